//! Curves with as few points as the eye needs: 10,000 samples become a few hundred.
//!
//! First each pixel column keeps its first, lowest, highest and last sample, so that no peak is lost; then points closer than a
//! quarter of a pixel to the chord of their neighbours are dropped (Ramer, 1972; Douglas and Peucker, 1973).

/// A point in pixels.
pub(super) type Point = (f64, f64);

const TOLERANCE_PX: f64 = 0.25;

/// Runs of finite points, each simplified.
pub(super) fn curves(points: &[Point]) -> Vec<Vec<Point>> {
    let finite = |point: &Point| point.0.is_finite() && point.1.is_finite();
    let runs = points
        .split(|point| !finite(point))
        .filter(|run| !run.is_empty());
    runs.map(|run| thin(&by_column(run))).collect()
}

/// First, lowest, highest and last point of each pixel column, in order.
fn by_column(run: &[Point]) -> Vec<Point> {
    let mut kept = Vec::new();
    for column in run.chunk_by(|a, b| a.0.floor() == b.0.floor()) {
        let by_height = |a: &usize, b: &usize| column[*a].1.total_cmp(&column[*b].1);
        let (lowest, highest) = (
            (0..column.len()).min_by(by_height),
            (0..column.len()).max_by(by_height),
        );
        let mut indices = vec![
            0,
            lowest.unwrap_or(0),
            highest.unwrap_or(0),
            column.len() - 1,
        ];
        indices.sort_unstable();
        indices.dedup();
        kept.extend(indices.into_iter().map(|i| column[i]));
    }
    kept
}

/// Drops points near the chord between kept ones.
fn thin(run: &[Point]) -> Vec<Point> {
    let mut keep = vec![false; run.len()];
    let last = run.len() - 1;
    (keep[0], keep[last]) = (true, true);
    let mut spans = vec![(0, last)];
    while let Some((first, last)) = spans.pop() {
        let distances = (first + 1..last).map(|i| (distance(run[i], run[first], run[last]), i));
        let farthest = distances.max_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((far, i)) = farthest
            && far > TOLERANCE_PX
        {
            keep[i] = true;
            spans.extend([(first, i), (i, last)]);
        }
    }
    run.iter()
        .zip(keep)
        .filter_map(|(point, keep)| keep.then_some(*point))
        .collect()
}

/// Distance of `p` from the segment a b.
fn distance(p: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let squared = dx * dx + dy * dy;
    let along = if squared > 0.0 {
        (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (p.0 - a.0 - along * dx).hypot(p.1 - a.1 - along * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled(f: impl Fn(f64) -> f64) -> Vec<Point> {
        (0..10_000)
            .map(|i| f64::from(i) * 0.04)
            .map(|x| (x, f(x)))
            .collect()
    }

    #[test]
    fn a_straight_line_keeps_its_ends() {
        let points = sampled(|x| 0.5 * x);
        assert_eq!(curves(&points), [vec![points[0], points[9999]]]);
    }

    #[test]
    fn every_sample_stays_within_a_quarter_pixel() {
        let points = sampled(|x| 100.0 + 80.0 * (x / 30.0).sin());
        let curve = &curves(&points)[0];
        assert!(curve.len() < 200, "{} points", curve.len());
        for point in &points {
            let nearest = curve
                .windows(2)
                .map(|pair| distance(*point, pair[0], pair[1]))
                .fold(f64::INFINITY, f64::min);
            assert!(
                nearest <= 2.0 * TOLERANCE_PX,
                "{point:?} is {nearest} px away"
            );
        }
    }

    #[test]
    fn a_spike_of_one_sample_survives() {
        let mut points = sampled(|_| 100.0);
        points[5000].1 = 3.0;
        assert!(curves(&points)[0].contains(&points[5000]));
    }

    #[test]
    fn a_gap_splits_the_curve() {
        assert_eq!(
            curves(&[(0.0, 1.0), (5.0, f64::NAN), (9.0, 1.0)]),
            [vec![(0.0, 1.0)], vec![(9.0, 1.0)]]
        );
        assert_eq!(curves(&[]), Vec::<Vec<Point>>::new());
    }
}
