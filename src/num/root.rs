//! A root between two places, by Newton's method that is never let out of its bracket.
use crate::num::Real;
use smallvec::{SmallVec, smallvec};

/// Steps after which the bracket has been halved beyond any double-double.
const STEPS: u32 = 400;

/// The places from 0 to `far` at which a value changes its sign, looked for in steps, at these `stops` and in the dips between them;
/// none beyond where there is no value.
///
/// Errors: those of the value, save at its steps.
pub fn changes<T: Real, E>(
    (far, step): (T, T),
    stops: &[T],
    value: &dyn Fn(T) -> Result<T, E>,
) -> Result<SmallVec<[T; 4]>, E> {
    let mut found = SmallVec::new();
    let Ok(first) = value(T::zero()) else { return Ok(found) };
    let mut seen: SmallVec<[(T, T); 3]> = smallvec![(T::zero(), first)];
    while let Some((before, last)) = seen.last().copied()
        && before.below(far)
    {
        let stops = stops.iter().copied().filter(|stop| before.below(*stop));
        let next =
            stops.chain([far]).fold(before + step, |one, other| if other.below(one) { other } else { one });
        let Ok(now) = value(next) else { break };
        if last.sign() * now.sign() < 0.0 {
            found.push(between_values(before, next, now.sign() > 0.0, value)?);
        } else if now.is_zero() {
            found.push(next);
        }
        seen.push((next, now));
        if let Some([left, at, right]) = dipped(&seen, value)? {
            let below = last.sign() > 0.0;
            found.push(between_values(left, at, !below, value)?);
            found.push(between_values(at, right, below, value)?);
        }
        if seen.len() == 3 {
            seen.remove(0);
        }
    }
    Ok(found)
}

/// The places from 0 to `far` at which an even value, whose bends are all wider than a step, is least or greatest.
pub fn turns<T: Real, E>((far, step): (T, T), value: &dyn Fn(T) -> Result<T, E>) -> SmallVec<[T; 4]> {
    let hair = step.scale2(-20);
    let grows = |x: T| {
        let more = value(x + hair)?.apart(value(x)?);
        // What stays as it is does not turn.
        Ok::<_, E>(if more.is_zero() { T::of(1.0) } else { more })
    };
    changes((far, step), &[], &grows).unwrap_or_default()
}

/// How a way is looked through: the first step, the widest to which steps grow, and the steps at least from one stop to the next.
pub type Looks = [f64; 3];

/// The first place at which a value that sets off above 0 (or `rising` below it) no longer is there, however shortly, on the way from 0
/// to the last of `stops`, at each of which its law changes: between which places. The values before it are `told`.
///
/// Errors: those of the value.
pub fn leaves<T: Real, E>(
    stops: impl Iterator<Item = T>,
    [mut step, widest, pieces]: Looks,
    rising: bool,
    value: &dyn Fn(T) -> Result<T, E>,
    told: &mut dyn FnMut(T),
) -> Result<Option<[T; 2]>, E> {
    let mut seen: SmallVec<[(T, T); 3]> = smallvec![(T::zero(), value(T::zero())?)];
    for stop in stops {
        // A spring may turn it back and forth within the little way on which it is met.
        let most = f64::min(widest, (stop - seen[seen.len() - 1].0).size() / pieces);
        while let Some((before, _)) = seen.last().copied()
            && before.below(stop)
        {
            // Two springs may be met within the last digit: so short a step leads nowhere.
            let next = before + T::of(f64::min(step, most));
            let next = if before.below(next) && next.below(stop) { next } else { stop };
            step = f64::min(2.0 * step, widest);
            let now = value(next)?;
            if now.sign() == 0.0 || (now.sign() > 0.0) == rising {
                return Ok(Some([before, next]));
            }
            told(now);
            seen.push((next, now));
            // Between two looks it may have been gone and back.
            if let Some([left, at, _]) = dipped(&seen, value)? {
                return Ok(Some([left, at]));
            }
            if seen.len() == 3 {
                seen.remove(0);
            }
        }
    }
    Ok(None)
}

/// Of three looks at a value that has one sign at all of them: a place between two of them where it has not, in the middle.
///
/// Errors: those of the value.
pub fn dipped<T: Real, E>(seen: &[(T, T)], value: &dyn Fn(T) -> Result<T, E>) -> Result<Option<[T; 3]>, E> {
    let mut around: SmallVec<[(T, T); 3]> = seen.iter().copied().collect();
    while let Some(at) = dip(&around) {
        let now = value(at)?;
        if now.sign() * around[1].1.sign() <= 0.0 {
            return Ok(Some([around[0].0, at, around[2].0]));
        }
        let middle = around[1];
        let deeper = now.size() < middle.1.size();
        around[if deeper == at.below(middle.0) { 2 } else { 0 }] = middle;
        if !deeper {
            break;
        }
        around[1] = (at, now);
    }
    Ok(None)
}

/// Where a parabola through three places of one sign has its bottom, if the one in the middle is the lowest by magnitude and it lies
/// well below that.
fn dip<T: Real>(around: &[(T, T)]) -> Option<T> {
    let [(a, high), (b, low), (c, far)] = around else { return None };
    if high.sign() * low.sign() <= 0.0 || far.sign() * low.sign() <= 0.0 {
        return None;
    }
    let [high, low, far] = [high, low, far].map(|x| x.abs());
    let (left, right) = (high - low, far - low);
    if left.sign() <= 0.0 || right.sign() < 0.0 {
        return None;
    }
    let (left, right) = (left / (*b - *a), right / (*c - *b));
    let bend = (left + right) / (*c - *a);
    // Slope at the middle, from the parabola.
    let slope = (right * (*b - *a) - left * (*c - *b)) / (*c - *a);
    let fall = slope.square() / bend.scale2(2);
    let at = *b - slope / bend.scale2(1);
    (low.scale2(-4).below(fall) && !(at - *b).is_zero()).then_some(at)
}

/// The root of a function without a known slope: by the secant of the last two values, never out of its bracket.
///
/// Errors: those of the value.
pub fn between_values<T: Real, E>(
    low: T,
    high: T,
    rising: bool,
    value: &dyn Fn(T) -> Result<T, E>,
) -> Result<T, E> {
    let mut last: Option<(T, T)> = None;
    between(low, high, rising, |x| {
        let now = value(x)?;
        let slope = match last {
            Some((at, before)) if !T::leading(|| (x - at).is_zero()) => (now - before) / (x - at),
            _ => T::zero(),
        };
        last = Some((x, now));
        Ok((now, slope))
    })
}

/// The place between `low` and `high` at which `f` changes its sign, from `rising`: below 0 at `low`, above at `high`; else
/// the other way. `f` gives value and slope.
///
/// Errors: those of `f`.
pub fn between<T: Real, E>(
    low: T,
    high: T,
    rising: bool,
    mut f: impl FnMut(T) -> Result<(T, T), E>,
) -> Result<T, E> {
    let (mut low, mut high) = (low, high);
    let mut x = (low + high).scale2(-1);
    let mut last = (high - low).size();
    for _ in 0..STEPS {
        let (value, slope) = f(x)?;
        let (zero, above) = T::leading(|| (value.is_zero(), value.sign() > 0.0));
        if zero {
            break;
        }
        if above == rising {
            high = x;
        } else {
            low = x;
        }
        let newton = (x - value / slope).or(x);
        let step = (newton - x).size();
        let inside = T::leading(|| low.below(newton) && newton.below(high));
        // Newton may not be slower than halving.
        let next = if inside && step + step <= last { newton } else { (low + high).scale2(-1) };
        last = (next - x).size();
        x = next;
        if last <= T::SETTLED * x.size() {
            break;
        }
    }
    Ok(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Dd;

    #[test]
    fn roots_of_a_cubic_with_a_flat_place() {
        let f = |x: Dd| Ok::<_, ()>((x * x * x - Dd::new(2.0), Dd::new(3.0) * x * x));
        let root = between(Dd::new(-1.0), Dd::new(4.0), true, f).unwrap();
        assert!((root * root * root - Dd::new(2.0)).hi.abs() < 1e-29, "{root:?}");
        let falling =
            between(Dd::ZERO, Dd::new(3.0), false, |x| Ok::<_, ()>((Dd::ONE - x, -Dd::ONE))).unwrap();
        assert_eq!(falling, Dd::ONE);
    }
}
