//! The same scene in other units of mass, length and time. Powers of two: every number of it keeps its digits.
//!
//! Products of data as large as 1e150 or as small as 1e-150 leave the doubles in SI units; in units of the scene's own size few do.
use crate::scene::{
    Arm, Attach, Body, CheckedUnit, Cord, CordEnd, Coordinate, Degree, End, Far, Mass, Num, Pin, Rest,
    RotaryInertia, Scene, Slope, Start, Tie,
};
