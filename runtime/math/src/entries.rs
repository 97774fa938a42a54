//! Functions of the entries of an array. A scalar type takes several entries at a time in the vector registers that the program is
//! compiled for; every entry gets the bits that it would get alone.

use crate::real::{Mask, Real};

/// A function of one number.
pub trait Each: Copy {
    /// Whether a part of a register is better filled up than split into narrower ones: so for a long function.
    const LONG: bool = false;
    /// Whether it branches for [`Each::is_rare`] arguments, so that an array of lanes is better searched for them as a whole.
    const BRANCHES: bool = false;
    /// The function; `#[inline(always)]` in every implementation.
    fn of<T: Real>(self, x: T) -> T;
    /// Arguments that [`Each::usual`] does not cover.
    #[inline(always)]
    fn is_rare<T: Real>(self, _x: T) -> T::Mask {
        T::Mask::splat(false)
    }
    /// The function of other arguments, without a branch.
    #[inline(always)]
    fn usual<T: Real>(self, x: T) -> T {
        self.of(x)
    }
}

/// A function of two numbers.
pub trait Each2: Copy {
    /// The function; `#[inline(always)]` in every implementation.
    fn of<T: Real>(self, x: T, y: T) -> T;
}

/// A function of three numbers.
pub trait Each3: Copy {
    /// The function; `#[inline(always)]` in every implementation.
    fn of<T: Real>(self, x: T, y: T, z: T) -> T;
}

/// A function of two numbers that gives two, long enough that a part of a register is better filled up than split.
pub trait EachPair: Copy {
    /// The function; `#[inline(always)]` in every implementation.
    fn of<T: Real>(self, x: T, y: T) -> [T; 2];
}

/// One entry after the other.
pub(crate) mod single {
    use super::{Each, Each2, Each3, EachPair};
    use crate::real::{Mask, Part, Real};

    #[inline(always)]
    pub(crate) fn each<T: Real, F: Each>(f: F, entries: &[T], results: &mut [T]) {
        if F::BRANCHES && !T::IS_SCALAR {
            return with_one_branch(f, entries, results);
        }
        let mut i = 0;
        while i < entries.len() {
            results[i] = f.of(entries[i]);
            i += 1;
        }
    }

    /// The usual values come before the branch, so that the compiler finds what they have in common with other functions of these entries.
    #[inline(always)]
    fn with_one_branch<T: Real>(f: impl Each, entries: &[T], results: &mut [T]) {
        let mut rare = T::Mask::splat(false);
        let mut i = 0;
        while i < entries.len() {
            rare = rare.or(f.is_rare(entries[i]));
            results[i] = f.usual(entries[i]);
            i += 1;
        }
        if rare.any() {
            rarely();
            let mut i = 0;
            while i < entries.len() {
                results[i] = T::outlined(Alone(f, entries[i]));
                i += 1;
            }
        }
    }

    /// Tells the compiler that its caller's branch is not taken.
    #[cold]
    #[inline(never)]
    fn rarely() {}

    /// The function of one entry, in a function of its own because it is rarely called.
    struct Alone<F, T>(F, T);

    impl<F: Each, T: Real> Part for Alone<F, T> {
        type Output = T;

        #[inline(always)]
        fn run(self) -> T {
            self.0.of(self.1)
        }
    }

    #[inline(always)]
    pub(crate) fn each2<T: Real>(f: impl Each2, entries: &mut [T], others: &[T]) {
        let mut i = 0;
        while i < entries.len() {
            entries[i] = f.of(entries[i], others[i]);
            i += 1;
        }
    }

    #[inline(always)]
    pub(crate) fn each3<T: Real>(f: impl Each3, entries: &mut [T], [y, z]: [&[T]; 2]) {
        let mut i = 0;
        while i < entries.len() {
            entries[i] = f.of(entries[i], y[i], z[i]);
            i += 1;
        }
    }

    #[inline(always)]
    pub(crate) fn each_pair<T: Real>(f: impl EachPair, entries: &mut [T], others: &mut [T]) {
        let mut i = 0;
        while i < entries.len() {
            [entries[i], others[i]] = f.of(entries[i], others[i]);
            i += 1;
        }
    }
}

/// As many entries at a time as the registers hold that the program may use: first whole registers, the widest ones first, then what is
/// left over. What is left of a long function is filled up to a register if it is more than half of one.
#[cfg(target_arch = "x86_64")]
pub(crate) mod packed {
    use super::{Each, Each2, Each3, EachPair, single};
    use crate::real::Real;

    const AVX2: bool = cfg!(target_feature = "avx2");
    const AVX512: bool = false;

    /// A register of `N` numbers `S`.
    pub(crate) trait Register<S, const N: usize>: Real {
        /// The register with these entries.
        fn load(entries: &[S; N]) -> Self;
        /// Its entries.
        fn store(self, entries: &mut [S; N]);
    }

    #[inline(always)]
    pub(crate) fn each<S, W, M, N, const WIDE: usize, const MIDDLE: usize, const NARROW: usize>(
        f: impl Each,
        entries: &[S],
        results: &mut [S],
    ) where
        S: Real,
        W: Register<S, WIDE>,
        M: Register<S, MIDDLE>,
        N: Register<S, NARROW>,
    {
        let mut rest = (entries, results);
        if AVX512 {
            rest = whole::<S, W, WIDE, _>(f, rest.0, rest.1);
        }
        if AVX2 {
            rest = whole::<S, M, MIDDLE, _>(f, rest.0, rest.1);
        }
        rest = whole::<S, N, NARROW, _>(f, rest.0, rest.1);
        single::each(f, rest.0, rest.1);
    }

    /// Takes whole registers off the front and gives the rest, or nothing if that was taken too.
    #[inline(always)]
    fn whole<'a, S: Real, L: Register<S, N>, const N: usize, F: Each>(
        f: F,
        entries: &'a [S],
        results: &'a mut [S],
    ) -> (&'a [S], &'a mut [S]) {
        let (chunks, rest) = entries.as_chunks::<N>();
        let (result_chunks, result_rest) = results.as_chunks_mut::<N>();
        let mut i = 0;
        while i < chunks.len() {
            f.of(L::load(&chunks[i])).store(&mut result_chunks[i]);
            i += 1;
        }
        if F::LONG && 2 * rest.len() > N {
            let mut values = filled(rest);
            f.of(L::load(&values)).store(&mut values);
            copy(&values, result_rest);
            return (&[], &mut []);
        }
        (rest, result_rest)
    }

    #[inline(always)]
    pub(crate) fn each2<S, W, M, N, const WIDE: usize, const MIDDLE: usize, const NARROW: usize>(
        f: impl Each2,
        entries: &mut [S],
        others: &[S],
    ) where
        S: Real,
        W: Register<S, WIDE>,
        M: Register<S, MIDDLE>,
        N: Register<S, NARROW>,
    {
        let mut rest = (entries, others);
        if AVX512 {
            rest = whole2::<S, W, WIDE>(f, rest.0, rest.1);
        }
        if AVX2 {
            rest = whole2::<S, M, MIDDLE>(f, rest.0, rest.1);
        }
        rest = whole2::<S, N, NARROW>(f, rest.0, rest.1);
        single::each2(f, rest.0, rest.1);
    }

    /// As [`whole`], of two arrays.
    #[inline(always)]
    fn whole2<'a, S: Real, L: Register<S, N>, const N: usize>(
        f: impl Each2,
        entries: &'a mut [S],
        others: &'a [S],
    ) -> (&'a mut [S], &'a [S]) {
        let (chunks, rest) = entries.as_chunks_mut::<N>();
        let (other_chunks, other_rest) = others.as_chunks::<N>();
        let mut i = 0;
        while i < chunks.len() {
            let (x, y) = (L::load(&chunks[i]), L::load(&other_chunks[i]));
            f.of(x, y).store(&mut chunks[i]);
            i += 1;
        }
        (rest, other_rest)
    }

    #[inline(always)]
    pub(crate) fn each3<S, W, M, N, const WIDE: usize, const MIDDLE: usize, const NARROW: usize>(
        f: impl Each3,
        entries: &mut [S],
        others: [&[S]; 2],
    ) where
        S: Real,
        W: Register<S, WIDE>,
        M: Register<S, MIDDLE>,
        N: Register<S, NARROW>,
    {
        let mut rest = (entries, others);
        if AVX512 {
            rest = whole3::<S, W, WIDE>(f, rest.0, rest.1);
        }
        if AVX2 {
            rest = whole3::<S, M, MIDDLE>(f, rest.0, rest.1);
        }
        rest = whole3::<S, N, NARROW>(f, rest.0, rest.1);
        single::each3(f, rest.0, rest.1);
    }

    /// As [`whole`], of three arrays.
    #[inline(always)]
    fn whole3<'a, S: Real, L: Register<S, N>, const N: usize>(
        f: impl Each3,
        entries: &'a mut [S],
        [y, z]: [&'a [S]; 2],
    ) -> (&'a mut [S], [&'a [S]; 2]) {
        let (chunks, rest) = entries.as_chunks_mut::<N>();
        let ((y, y_rest), (z, z_rest)) = (y.as_chunks::<N>(), z.as_chunks::<N>());
        let mut i = 0;
        while i < chunks.len() {
            let (x, y, z) = (L::load(&chunks[i]), L::load(&y[i]), L::load(&z[i]));
            f.of(x, y, z).store(&mut chunks[i]);
            i += 1;
        }
        (rest, [y_rest, z_rest])
    }

    #[inline(always)]
    pub(crate) fn each_pair<
        S,
        W,
        M,
        N,
        const WIDE: usize,
        const MIDDLE: usize,
        const NARROW: usize,
    >(
        f: impl EachPair,
        entries: &mut [S],
        others: &mut [S],
    ) where
        S: Real,
        W: Register<S, WIDE>,
        M: Register<S, MIDDLE>,
        N: Register<S, NARROW>,
    {
        let mut rest = (entries, others);
        if AVX512 {
            rest = whole_pairs::<S, W, WIDE>(f, rest.0, rest.1);
        }
        if AVX2 {
            rest = whole_pairs::<S, M, MIDDLE>(f, rest.0, rest.1);
        }
        rest = whole_pairs::<S, N, NARROW>(f, rest.0, rest.1);
        single::each_pair(f, rest.0, rest.1);
    }

    /// As [`whole`], of two arrays that both get results.
    #[inline(always)]
    fn whole_pairs<'a, S: Real, L: Register<S, N>, const N: usize>(
        f: impl EachPair,
        entries: &'a mut [S],
        others: &'a mut [S],
    ) -> (&'a mut [S], &'a mut [S]) {
        let (chunks, rest) = entries.as_chunks_mut::<N>();
        let (other_chunks, other_rest) = others.as_chunks_mut::<N>();
        let pair = |x: &mut [S; N], y: &mut [S; N]| {
            let [first, second] = f.of(L::load(x), L::load(y));
            first.store(x);
            second.store(y);
        };
        let mut i = 0;
        while i < chunks.len() {
            pair(&mut chunks[i], &mut other_chunks[i]);
            i += 1;
        }
        if 2 * rest.len() > N {
            let (mut x, mut y) = (filled(rest), filled(other_rest));
            pair(&mut x, &mut y);
            copy(&x, rest);
            copy(&y, other_rest);
            return (&mut [], &mut []);
        }
        (rest, other_rest)
    }

    /// The entries and, to fill up the array, the first one again.
    #[inline(always)]
    fn filled<S: Copy, const N: usize>(entries: &[S]) -> [S; N] {
        let mut array = [entries[0]; N];
        copy(entries, &mut array);
        array
    }

    /// Copies as many entries as both have.
    #[inline(always)]
    fn copy<S: Copy>(from: &[S], to: &mut [S]) {
        let mut i = 0;
        while i < from.len() && i < to.len() {
            to[i] = from[i];
            i += 1;
        }
    }
}
