//! Pictures of scenes: layout first, looks and formats second ([`svg`], [`tikz`]).
//!
//! [`scene::picture`] is the figure of a statement. It shows what is given and what a student may assume, never what the
//! solver found: no direction that is asked, no friction.
pub mod board;
pub mod lamina;
pub mod layout;
pub mod picture;
pub mod pinned;
pub mod say;
pub mod scene;
pub mod svg;
pub mod symbol;
pub mod tikz;
pub mod vector;
pub mod view;
