//! Instants of joined bodies: just after a blow, as they are driven, or as they set off.
use crate::num::Real;
use crate::scene::{Owner, Quantity};
use crate::solve::eom::joined::tell::beside;
use crate::solve::eom::joined::{Teller, rubbing, sliding};
use crate::solve::eom::planar::Response;
use crate::solve::outcome::{self, Course, Refusal};

/// The instant of the start, from this rate.
pub fn at_once<T: Real>(teller: &mut Teller<T>, spin: T, nothing: &[f64]) -> Result<(), Refusal> {
    let (scene, mechanism) = (teller.scene, teller.mechanism);
    let (state, spin) = if scene.tells_speeds() {
        mechanism.told()?
    } else {
        (mechanism.state(T::zero(), !spin.is_zero() || teller.pinned.is_some())?, spin)
    };
    if scene.is_struck() {
        let jumps = mechanism.struck(&state)?;
        teller.tell_blow(&state, &jumps);
        teller.tell_motion(&mechanism.after(state, spin, &jumps), T::of(1.0), None);
        return Ok(());
    }
    if let Some(alpha) = scene.driven() {
        return driven(teller, teller.n.get(alpha), spin);
    }
    let smooth = mechanism.respond(&state, nothing)?;
    // What starts from rest slides as it would without friction, if friction lets it.
    let from_rest = |response: &Response<T>| sliding(mechanism, &state, (&response.moves[0], 1.0));
    let mut slides = if spin.is_zero() {
        from_rest(&smooth)
    } else {
        sliding(mechanism, &state, (&state.rates, spin.sign()))
    };
    if !spin.is_zero() {
        outcome::all_slide(scene, &slides)?;
    }
    let (rubs, response) = loop {
        let rubs = rubbing(mechanism, &slides, spin.square(), &|rubs| mechanism.respond(&state, rubs))?;
        let response = mechanism.respond(&state, &rubs)?;
        let now = if spin.is_zero() { from_rest(&response) } else { slides.clone() };
        if now == slides {
            break (rubs, response);
        }
        let Some(more) = outcome::set_off(&slides, &now) else {
            outcome::holds_still(scene, &slides, &now)?;
            teller.road.course = Some(Course::at_rest());
            return Ok(());
        };
        slides = more;
    };
    teller.watch(&response, spin.square());
    let lead = response.lead;
    teller.tell(&state, &response, (spin, lead), &rubs)
}

/// An instant of what is driven with this angular acceleration: from rest it sets off as it is driven.
fn driven<T: Real>(teller: &mut Teller<T>, alpha: T, spin: T) -> Result<(), Refusal> {
    let (scene, mechanism) = (teller.scene, teller.mechanism);
    let way = if spin.is_zero() { alpha / mechanism.layout.ratio() } else { spin };
    let state = mechanism.state(T::zero(), true)?;
    let slides = sliding(mechanism, &state, (&state.rates, way.sign()));
    outcome::all_slide(scene, &slides)?;
    let driven = |rubs: &[f64]| mechanism.driven(&state, rubs, alpha);
    let rubs = rubbing(mechanism, &slides, spin.square(), &|rubs| Ok(driven(rubs)?.0))?;
    let (response, couple) = driven(&rubs)?;
    let (constant, by_square) = couple.ok_or(Refusal::Freedoms(0))?;
    let moment = constant.balance(by_square * spin.square());
    let arm = mechanism.size();
    let size = beside(moment.size() + teller.pulls() * arm, teller.loads(spin.square()) * arm);
    teller.say_scaled(Quantity::Drive, Owner::Body(mechanism.lead), moment, size);
    teller.tell_powers(&state, spin, Some((moment, size)));
    teller.watch(&response, spin.square());
    let lead = response.lead;
    teller.tell(&state, &response, (spin, lead), &rubs)
}
