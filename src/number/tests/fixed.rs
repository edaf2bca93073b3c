use dashu_int::IBig;
use proptest::prelude::*;

use crate::number::fixed::Fixed;
use crate::predicate::Sign;

/// The value of two's complement limbs.
fn value<const N: usize>(x: Fixed<N>) -> IBig {
    let unsigned = x.0.iter().rev().fold(IBig::ZERO, |sum, limb| (sum << 64) + IBig::from(*limb));
    if x.0[N - 1] >> 63 == 1 { unsigned - (IBig::ONE << (64 * N)) } else { unsigned }
}

fn halved<const N: usize>(limbs: [u64; N]) -> Fixed<N> {
    // Sign extended by one bit, so that a sum of two fits.
    let mut out = limbs;
    out[N - 1] = (out[N - 1].cast_signed() >> 1).cast_unsigned();
    Fixed(out)
}

fn arithmetic<const N: usize, const P: usize>(x: [u64; N], y: [u64; N]) {
    let (x, y) = (halved(x), halved(y));
    let (vx, vy) = (value(x), value(y));
    assert_eq!(value(x.plus(y)), &vx + &vy);
    assert_eq!(value(x.minus(y)), &vx - &vy);
    assert_eq!(x.sign(), Sign::from(vx.cmp(&IBig::ZERO)));
    let product: Fixed<P> = x.magnitude().times(&y.magnitude());
    assert_eq!(value(product), vx * vy);
}

fn limb() -> impl Strategy<Value = u64> {
    prop_oneof![any::<u64>(), Just(0), Just(u64::MAX), Just(1), Just(1 << 63)]
}

proptest! {
    #[test]
    fn one_limb(x in limb(), y in limb()) {
        arithmetic::<1, 2>([x], [y]);
        arithmetic::<1, 3>([x], [y]);
    }

    #[test]
    fn two_limbs(x in prop::array::uniform2(limb()), y in prop::array::uniform2(limb())) {
        arithmetic::<2, 4>(x, y);
    }

    #[test]
    fn five_limbs(x in prop::array::uniform5(limb()), y in prop::array::uniform5(limb())) {
        arithmetic::<5, 10>(x, y);
    }

    #[test]
    fn shifted_mantissas(mantissa in -(1_i64 << 53)..(1 << 53), shift in 0_u32..260) {
        prop_assert_eq!(value(Fixed::<5>::shifted(mantissa, shift)), IBig::from(mantissa) << shift as usize);
        if shift < 70 {
            prop_assert_eq!(value(Fixed::<2>::shifted(mantissa, shift)), IBig::from(mantissa) << shift as usize);
        }
        if shift < 10 {
            prop_assert_eq!(value(Fixed::<1>::shifted(mantissa, shift)), IBig::from(mantissa) << shift as usize);
        }
    }
}
