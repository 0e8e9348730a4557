//! The fixed tables behind noise (docs/spec/patterns-textures.md 1.1 … 1.4, 1.7), built when first used.

use std::sync::LazyLock;

use glam::DVec3;

/// The linear congruential stream of docs/spec/patterns-textures.md 1.1.
pub(super) struct Stream(pub(super) u32);

impl Stream {
    /// The next output, 0 … 32767.
    pub(super) fn next(&mut self) -> usize {
        self.0 = self.0.wrapping_mul(1_812_433_253).wrapping_add(12345);
        (self.0 >> 16 & 0x7fff) as usize
    }
}

/// Entries of [`HASH`], a power of two: indices need no range check after masking.
pub(super) const HASH_SIZE: usize = 8192;

/// The lattice hash table H: a shuffle of 0 … 4095, twice.
pub(super) static HASH: LazyLock<Box<[u16; HASH_SIZE]>> = LazyLock::new(|| {
    let mut table = Box::new([0; HASH_SIZE]);
    let (first, second) = table.split_at_mut(HASH_SIZE / 2);
    for (entry, number) in first.iter_mut().zip(0..) {
        *entry = number;
    }
    let mut stream = Stream(0);
    for i in (0..first.len()).rev() {
        first.swap(i, stream.next() % 4096);
    }
    second.copy_from_slice(first);
    table
});

/// Added to the number of a lattice plane before it is hashed.
pub(super) const SHIFT: i32 = 10000;

/// Length of the gradient table: the largest corner starts at 255 + 8 and reads four entries.
pub(super) const GRADIENTS: usize = 267;

/// The gradient table R.
pub(super) static GRADIENT: LazyLock<[f64; GRADIENTS]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let bytes = (0.12345 * i as f64).to_be_bytes();
        let mut check = 0_u16;
        for byte in bytes.into_iter().cycle().take(24) {
            check ^= u16::from(byte);
            for _ in 0..8 {
                check = check >> 1 ^ if check & 1 == 1 { 0xA001 } else { 0 };
            }
        }
        round_to_six_digits(2.0 * f64::from(check) / 65535.0 - 1.0)
    })
});

/// For each number of a corner half an entry of the gradient table, and the three after it.
pub(super) static SLOPES: LazyLock<Box<[[f64; 4]; 256]>> = LazyLock::new(|| {
    let r = &*GRADIENT;
    Box::new(std::array::from_fn(|m| [0.5 * r[m], r[m + 1], r[m + 2], r[m + 3]]))
});

/// The published table has six significant digits.
fn round_to_six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// Entries of [`UNIFORM`].
pub(super) const UNIFORM_SIZE: usize = 32768;

/// The uniform table U: the first outputs of MT19937 with its default seed, over 2³².
pub(super) static UNIFORM: LazyLock<Box<[f64]>> = LazyLock::new(|| {
    const N: usize = 624;
    let mut state = [5489_u32; N];
    for i in 1..N {
        let last = state[i - 1];
        state[i] = (last ^ last >> 30).wrapping_mul(1_812_433_253).wrapping_add(i as u32);
    }
    (0..UNIFORM_SIZE)
        .map(|k| {
            // Renew one word of the state, then temper it.
            let i = k % N;
            let joined = state[i] & 0x8000_0000 | state[(i + 1) % N] & 0x7fff_ffff;
            let twist = if joined & 1 == 1 { 0x9908_b0df } else { 0 };
            state[i] = state[(i + 397) % N] ^ joined >> 1 ^ twist;
            let mut y = state[i];
            y ^= y >> 11;
            y ^= y << 7 & 0x9d2c_5680;
            y ^= y << 15 & 0xefc6_0000;
            y ^= y >> 18;
            f64::from(y) / 4_294_967_296.0
        })
        .collect()
});

/// Entries of each table of generator 3.
pub(super) const PERLIN_SIZE: usize = 2048;

/// The tables of generator 3: the shuffle P and the unit gradients G.
pub(super) struct Perlin {
    /// P.
    pub(super) shuffle: [u16; PERLIN_SIZE],
    /// G.
    pub(super) gradient: [DVec3; PERLIN_SIZE],
    /// The same behind a 0, as [`SLOPES`] are behind heights.
    pub(super) slopes: [[f64; 4]; PERLIN_SIZE],
}

/// See [`Perlin`].
pub(super) static PERLIN: LazyLock<Box<Perlin>> = LazyLock::new(|| {
    let mut stream = Stream(1);
    let mut gradient = [DVec3::ZERO; PERLIN_SIZE];
    for entry in &mut gradient {
        loop {
            let mut component = || ((stream.next() % 4096) as f64 - 2048.0) / 2048.0;
            let drawn = DVec3::new(component(), component(), component());
            let square = drawn.x * drawn.x + drawn.y * drawn.y + drawn.z * drawn.z;
            if (1e-5..=1.0).contains(&square) {
                *entry = drawn * (1.0 / square.sqrt());
                break;
            }
        }
    }
    // The shuffle runs over one entry too many, as POV-Ray's does, so one number comes twice.
    let mut shuffle: [u16; PERLIN_SIZE + 1] = std::array::from_fn(|k| (k % PERLIN_SIZE) as u16);
    for i in (2..=PERLIN_SIZE).rev().step_by(2) {
        shuffle.swap(i, stream.next() % PERLIN_SIZE);
    }
    let slopes = gradient.map(|g| [0.0, g.x, g.y, g.z]);
    Box::new(Perlin { shuffle: std::array::from_fn(|k| shuffle[k]), gradient, slopes })
});

/// Whether any of the tables has been made.
pub(super) fn exist() -> bool {
    let lattice = LazyLock::get(&HASH).is_some() || LazyLock::get(&GRADIENT).is_some();
    lattice || LazyLock::get(&UNIFORM).is_some() || LazyLock::get(&PERLIN).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_the_specified_ones() {
        assert_eq!(HASH[..8], [2291, 2574, 3654, 1557, 1196, 3388, 2637, 1820]);
        assert_eq!([HASH[2047], HASH[2048], HASH[4094], HASH[4095]], [2367, 3042, 3816, 3088]);
        let expected = [0.814723691903055, 0.135477004107088, 0.905791934113950];
        for (drawn, expected) in UNIFORM.iter().zip(expected) {
            assert!((drawn - expected).abs() < 1e-15);
        }
        assert!((UNIFORM[32767] - 0.752209920668975).abs() < 1e-15);
        assert_eq!(PERLIN.shuffle[..8], [0, 1, 386, 3, 649, 1576, 1405, 7]);
        assert_eq!(PERLIN.shuffle[2040..], [1590, 2041, 1802, 2043, 1690, 2045, 1710, 2047]);
        assert_eq!(PERLIN.shuffle.iter().filter(|k| **k == 0).count(), 2);
        let last = DVec3::new(0.107932576070689, 0.651988061264223, -0.750507912677585);
        assert!(PERLIN.gradient[2047].abs_diff_eq(last, 1e-15));
    }

    #[test]
    fn gradients_follow_from_the_checksum() {
        let published = include_str!("../../../docs/spec/data/noise-gradients.txt");
        let numbers: Vec<f64> = published.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        let tail = &numbers[numbers.len() - GRADIENTS..];
        assert_eq!(tail, &GRADIENT[..]);
    }
}
