//! The network (4), the barrier (31) and what both blocks of the controller share.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::{Basis, Vector3};

/// Largest argument of the barrier.
const CLAMP: f64 = FRAC_PI_2 - 1e-3;

/// The 19 monomials of three inputs up to degree 3 in at most two of them.
#[inline]
pub fn basis(z: &Vector3) -> Basis {
    let (a, b, c) = (z.x, z.y, z.z);
    let (aa, ab, ac, bb, bc, cc) = (a * a, a * b, a * c, b * b, b * c, c * c);
    Basis::from_column_slice(&[
        1.0,
        a,
        b,
        c,
        aa,
        ab,
        ac,
        bb,
        bc,
        cc,
        aa * a,
        aa * b,
        aa * c,
        a * bb,
        a * cc,
        bb * b,
        bb * c,
        b * cc,
        cc * c,
    ])
}

/// The barrier at an error and its bound.
pub struct Barrier {
    /// `s = e^T e`
    pub s: f64,
    /// `E = pi s^2 / (2 k^4)`, not clamped.
    pub free: f64,
    /// `sin E` and `cos E` of the clamped `E`.
    pub sin: f64,
    pub cos: f64,
    /// `cos^2 E`
    pub cos2: f64,
    /// `c = s e / cos^2 E`
    pub c: Vector3,
    /// `(4 kbar + K) k^4/(2 pi) sin E cos E/s^2 e + kbar e`
    pub lam0: Vector3,
}

#[inline]
pub fn barrier(e: &Vector3, bound: f64, gain: f64, kbar: f64) -> Barrier {
    let s = e.norm_squared();
    let ratio = s / (bound * bound);
    let free = FRAC_PI_2 * ratio * ratio;
    let clamped = free.min(CLAMP);
    let (sin, cos) = clamped.sin_cos();
    let cos2 = cos * cos;
    // k^4/(2 pi) sin E cos E/s^2 = sin(2 E)/(2 E) / 4 E/E_free, 1/4 where the error is zero
    let smooth = if clamped == 0.0 { 1.0 } else { sin * cos / clamped };
    let smooth = smooth * (CLAMP / free).min(1.0);
    let lam0 = e * (smooth * (4.0 * kbar + gain) / 4.0 + kbar);
    Barrier { s, free, sin, cos, cos2, c: e * (s / cos2), lam0 }
}

impl Barrier {
    /// `||Ybar||` (58) of three channels, Frobenius.
    #[inline]
    pub fn ybar_norm(&self) -> f64 {
        let spread = 3.0 / self.cos2;
        let along = 8.0 * self.free * self.sin / (self.cos2 * self.cos) + spread;
        (along * along + 2.0 * spread * spread).sqrt()
    }
}

/// The reference (83) and its rate, rad and rad/s.
#[inline]
pub fn reference(t: f64) -> (Vector3, Vector3) {
    const DEGREE: f64 = PI / 180.0;
    let (sin_phase, cos_phase) = (0.25 * PI * t - 0.5 * PI).sin_cos();
    let (sin_beta, cos_beta) = (0.3 * PI * t).sin_cos();
    let (sin_mu, cos_mu) = t.sin_cos();
    let (sin_half, cos_half) = (0.5 * t).sin_cos();
    let (alpha, alpha_rate) = if t <= 4.0 { (2.5 * sin_phase + 1.5, 2.5 * 0.25 * PI * cos_phase) } else { (4.0, 0.0) };
    let reference = Vector3::new(alpha, 0.5 * sin_beta, -2.0 * sin_mu + 0.5 * cos_half) * DEGREE;
    let rate = Vector3::new(alpha_rate, 0.5 * 0.3 * PI * cos_beta, -2.0 * cos_mu - 0.25 * sin_half) * DEGREE;
    (reference, rate)
}

/// The bound of both blocks: `3 e^-t + 0.5`, in degrees for the attitude, in rad/s for the rates.
#[inline]
pub fn bound(t: f64) -> f64 {
    3.0 * (-t).exp() + 0.5
}
