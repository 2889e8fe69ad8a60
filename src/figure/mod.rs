//! Pictures of scenes: layout first ([`picture`]), looks and formats second ([`svg`], [`tikz`]).
pub mod picture;
