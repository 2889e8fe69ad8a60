//! slipstick makes and grades homework in rigid-body dynamics.
//!
//! Words used throughout: a **bank** is what an instructor writes; a **problem** of it has **data** that are drawn on
//! decimal grids, a **scene** (bodies, ties, forces, start, end) and **questions**. A **draw** gives one **variant** for
//! one student. The scene is solved by two roads, the equations of motion and work and energy; where they agree the
//! answers become the **key**. A student's cell becomes an **answer**; key and answer give a **verdict**.
//!
//! Data flow: bank -> draw -> scene -> solve (eom | energy) -> key -> sheet, and
//! submissions -> answer -> grade -> report.
pub mod answer;
pub mod bank;
pub mod cli;
pub mod draw;
pub mod finding;
pub mod grade;
pub mod key;
pub mod num;
pub mod problem;
pub mod report;
pub mod scene;
pub mod set;
pub mod sheet;
pub mod simulate;
pub mod solve;
pub mod template;
pub mod units;
