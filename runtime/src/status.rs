//! What a control step reports besides its output.

use core::ops::{BitOr, BitOrAssign};

/// A set of events of one control step. The step is total: whatever happens, its output is finite and its states are usable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Status(u8);

impl Status {
    /// Nothing to report: the empty set.
    pub const OK: Self = Self(0);
    /// A constrained error reached its bound; the barrier was clamped short of its pole.
    pub const CONSTRAINT_VIOLATED: Self = Self(1);
    /// Some input was limited to its range.
    pub const SATURATED: Self = Self(1 << 1);
    /// A measurement, a next state or the control was NaN or infinite, so the output is the safe one. After a measurement that is not
    /// finite the states are as they were; where the law overflowed on finite ones they are given up, and the next finite sample starts anew.
    pub const NON_FINITE_INPUT: Self = Self(1 << 2);

    /// Whether every event of `events` is in the set.
    #[inline(always)]
    pub const fn contains(self, events: Self) -> bool {
        self.0 & events.0 == events.0
    }

    /// Whether the set is empty.
    #[inline(always)]
    pub const fn is_ok(self) -> bool {
        self.0 == 0
    }

    /// The events of `self` if `condition` holds, else none.
    #[inline(always)]
    pub const fn when(self, condition: bool) -> Self {
        if condition { self } else { Self::OK }
    }

    /// The set as bits: 1 constraint violated, 2 saturated, 4 non-finite input.
    #[inline(always)]
    pub const fn bits(self) -> u8 {
        self.0
    }
}

impl BitOr for Status {
    type Output = Self;

    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl BitOrAssign for Status {
    #[inline(always)]
    fn bitor_assign(&mut self, other: Self) {
        *self = *self | other;
    }
}

#[cfg(test)]
mod tests {
    use super::Status;

    #[test]
    fn events_are_independent() {
        let mut status = Status::OK;
        assert!(status.is_ok());
        status |= Status::SATURATED.when(true) | Status::NON_FINITE_INPUT.when(false);
        assert!(status.contains(Status::SATURATED) && !status.is_ok());
        assert!(
            !status.contains(Status::NON_FINITE_INPUT)
                && !status.contains(Status::SATURATED | Status::CONSTRAINT_VIOLATED)
        );
        assert_eq!((status | Status::CONSTRAINT_VIOLATED).bits(), 0b11);
    }
}
