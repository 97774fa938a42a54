//! The generator Philox4x32-10 of Salmon, Moraes, Dror and Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11.

use crate::real::Bits;

/// Two words of key for each round.
pub(super) type Keys = [[u32; 2]; 10];

/// Philox with four 32-bit words and ten rounds, one counter in each lane. The low 32 bits of each lane are the words.
#[inline(always)]
pub fn philox4x32_10<B: Bits>(counter: [B; 4], key: [u32; 2]) -> [B; 4] {
    encrypted(counter, &round_keys(key))
}

/// The key advances by two Weyl constants after each round.
#[inline(always)]
pub(super) fn round_keys(key: [u32; 2]) -> Keys {
    let mut keys = [key; 10];
    let mut i = 1;
    while i < keys.len() {
        let [k0, k1] = keys[i - 1];
        keys[i] = [k0.wrapping_add(0x9e37_79b9), k1.wrapping_add(0xbb67_ae85)];
        i += 1;
    }
    keys
}

/// The words of one counter.
#[inline(always)]
pub(super) fn encrypted<B: Bits>(counter: [B; 4], keys: &Keys) -> [B; 4] {
    let mut blocks = [counter];
    encrypt(&mut blocks, 1, keys);
    blocks[0]
}

/// Replaces the first `count` counters by their words. They take each round together: one alone waits for its products most of the time. The
/// rounds are no loop, which would mask words and spread keys to the lanes in each of them if it were not unrolled.
#[inline(always)]
pub(super) fn encrypt<B: Bits, const N: usize>(
    blocks: &mut [[B; 4]; N],
    count: usize,
    [k0, k1, k2, k3, k4, k5, k6, k7, k8, k9]: &Keys,
) {
    round(blocks, count, k0);
    round(blocks, count, k1);
    round(blocks, count, k2);
    round(blocks, count, k3);
    round(blocks, count, k4);
    round(blocks, count, k5);
    round(blocks, count, k6);
    round(blocks, count, k7);
    round(blocks, count, k8);
    round(blocks, count, k9);
}

/// Multiplies words 0 and 2 by two constants, exchanges high and low halves and mixes in the key.
#[inline(always)]
fn round<B: Bits, const N: usize>(blocks: &mut [[B; 4]; N], count: usize, &[k0, k1]: &[u32; 2]) {
    let mut i = 0;
    while i < count {
        let [c0, c1, c2, c3] = blocks[i];
        let (low0, high0) = c0.mul_wide(B::splat(0xd251_1f53));
        let (low1, high1) = c2.mul_wide(B::splat(0xcd9e_8d57));
        blocks[i] = [
            high1.xor(c1).xor(B::splat(u64::from(k0))),
            low1,
            high0.xor(c3).xor(B::splat(u64::from(k1))),
            low0,
        ];
        i += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::philox4x32_10;

    #[test]
    fn philox_gives_the_known_answers_of_random123() {
        let check = |counter: [u32; 4], key, expected: [u32; 4]| {
            assert_eq!(philox4x32_10(counter, key), expected);
            assert_eq!(
                philox4x32_10(counter.map(u64::from), key).map(|word| word as u32),
                expected
            );
        };
        check(
            [0; 4],
            [0; 2],
            [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8],
        );
        check(
            [u32::MAX; 4],
            [u32::MAX; 2],
            [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd],
        );
        check(
            [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
            [0xa409_3822, 0x299f_31d0],
            [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1],
        );
    }
}
