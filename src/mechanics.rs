//! The mechanics of slipstick: [`scene`] says what there is, [`solve`] finds what becomes of it on two roads, with the arithmetic of
//! [`num`]. It knows no banks, students or texts. A package of its own, so that a change of what stands above does not
//! compile it anew, and so that it alone may be optimised.
#![cfg_attr(not(feature = "program"), allow(dead_code, reason = "a page needs less than the program"))]

#[macro_use]
mod worded;

pub mod num;
pub mod scene;
pub mod solve;
