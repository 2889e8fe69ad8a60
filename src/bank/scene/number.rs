//! The numbers of a scene: a symbol of the data, a constant with its unit, an expression, or `any`.
use crate::bank::any::AnyNumber;
use crate::bank::expression::{Exponents, Expression, Name};
use crate::bank::measure;
use crate::bank::need::Need;
use crate::bank::node::{Fields, Node, Value, shorten};
use crate::bank::scene::{DatumUse, SceneReader};
use crate::num::decimal::one_of;
use crate::num::formula::{Formula, Step};
use crate::scene::{Derived, Given, Num};
use crate::units::spell;

impl SceneReader<'_> {
    /// Is this the symbol of a datum that is not there in this case?
    pub(super) fn absent(&self, node: &Node) -> bool {
        let text = node.text().map(str::trim);
        self.symbols.iter().any(|s| s.absent && Some(s.name.as_str()) == text)
    }

    /// Is everything that is written in this node the symbol of such a datum?
    pub(super) fn all_absent(&self, node: &Node) -> bool {
        match &node.value {
            Value::Map(fields) => !fields.is_empty() && fields.iter().all(|(_, v)| self.all_absent(v)),
            Value::List(items) => !items.is_empty() && items.iter().all(|v| self.all_absent(v)),
            _ => self.absent(node),
        }
    }

    /// A speed or a spin at the start: 0 where its datum is not there.
    pub(super) fn at_start(&self, node: &Node, need: &Need) -> Option<Num> {
        if self.absent(node) { Some(Num::Fixed(0.0)) } else { self.number(node, need) }
    }

    pub(super) fn number(&self, node: &Node, need: &Need) -> Option<Num> {
        let f = self.faults;
        let Some(text) = node.text().map(str::trim) else {
            let hint = format!("a symbol of the data, or a constant such as `{}`", need.example);
            return f.expected(node, need.words, hint);
        };
        if text == "any" {
            return self.any(node, need);
        }
        if let Some(datum) = self.symbols.iter().position(|s| s.name == text) {
            // A unit that is wrong is a finding already; the datum counts as used all the same.
            if let Some(unit) = self.symbols[datum].unit.as_ref().filter(|u| !measure::fits(u, need.unit)) {
                let message =
                    format!("`{text}` has the unit {}, but it is used as {}", unit.ascii(), need.words);
                let hint = format!("{} has a unit such as {}", need.words, need.unit);
                return f.refuse_with(node, message, hint);
            }
            self.met.borrow_mut().uses.push(DatumUse { datum, need: *need });
            return Some(Num::Datum(datum));
        }
        if is_expression(text) {
            return self.derived(node, text, need, measure::own_powers(need.unit));
        }
        if text.is_empty() || text.starts_with(|c: char| c.is_alphabetic() || c == '_') {
            let known = self.symbols.iter().map(|s| s.name.as_str());
            let hint = spell::did_you_mean(text, known.clone()).unwrap_or_else(|| {
                format!(
                    "symbols: {}; or a constant such as `{}`",
                    known.collect::<Vec<_>>().join(", "),
                    need.example
                )
            });
            return f.refuse_with(node, format!("`{}` is no symbol of the data", shorten(text)), hint);
        }
        match measure::constant(text, need.unit) {
            Ok(value) => self.constant(node, text, value, need),
            Err(message) => {
                let hint = match text.contains('(') || text.contains(" - ") || text.contains(" + ") {
                    true => "a number within an expression has no unit: make it a datum and write its symbol; angles count in radians there, as `pi/2 - x`".to_owned(),
                    false => format!("{} is written like `{}`", need.words, need.example),
                };
                f.refuse_with(node, message, hint)
            }
        }
    }

    /// A number that no datum enters, if its use admits it.
    pub(super) fn constant(&self, node: &Node, text: &str, value: f64, need: &Need) -> Option<Num> {
        match need.admits(value) {
            Ok(()) => Some(Num::Fixed(value)),
            Err(message) => self.faults.refuse(node, format!("`{}`: {message}", shorten(text))),
        }
    }

    /// A mass or a radius that cancels: 1 in its unit, which is proved to make no difference.
    pub(super) fn any(&self, node: &Node, need: &Need) -> Option<Num> {
        let text = match need.words {
            words if words == Need::MASS.words => "m",
            words if words == Need::RADIUS.words => "R",
            _ => {
                let hint = "only a mass or the radius of a shape may be `any`, where it cancels";
                return self.faults.refuse_with(node, format!("{} cannot be `any`", need.words), hint);
            }
        };
        let formula = Formula::new(vec![Step::Number(1.0)]);
        let mut derived = self.derived.borrow_mut();
        derived.push(Derived { formula, degrees: false, text: text.to_owned(), any: true });
        let number = Num::Derived(derived.len() - 1);
        self.met.borrow_mut().any.push(AnyNumber { node: node.clone(), number });
        Some(number)
    }

    /// A number that is worked out from data, such as `2*R` or `-w0`, and the dimension that it has.
    pub(super) fn derived(&self, node: &Node, text: &str, need: &Need, wanted: Exponents) -> Option<Num> {
        let f = self.faults;
        let lookup = |name: &str| -> Result<(Name, Exponents), (String, Option<String>)> {
            if name == "g" {
                return Ok((Name::Datum(self.gravity, false), measure::own_powers("m/s^2")));
            }
            let Some(datum) = self.symbols.iter().position(|s| s.name == name) else {
                let known = self.symbols.iter().map(|s| s.name.as_str());
                let hint = spell::hint(name, "symbols", known);
                return Err((format!("`{}` is no symbol of the data", shorten(name)), Some(hint)));
            };
            let symbol = &self.symbols[datum];
            if symbol.absent {
                return Err((format!("`{name}` is not drawn"), Some("draw it, or leave it out".to_owned())));
            }
            let powers = symbol.unit.as_ref().map_or([0; 3], measure::powers);
            Ok((Name::Datum(datum, false), powers))
        };
        let mut read = Expression::parse(text, &lookup);
        if read.is_err() && self.symbols.iter().any(|s| s.unit.is_none()) {
            // A unit that is wrong is a finding already, and no sum can be judged without it.
            read = Expression::parse_loosely(text, &lookup);
        }
        let expression = read.map_err(|fault| fault.tell(node, text, f)).ok()?;
        let data: Vec<usize> = expression.data().collect();
        let own = |i: usize| self.symbols.get(i);
        let known = data.iter().all(|i| own(*i).is_none_or(|s| s.unit.is_some()));
        if known && expression.powers != wanted {
            let found = measure::powers_text(expression.powers);
            let message =
                format!("`{}` has the dimension {found}, but it is used as {}", shorten(text), need.words);
            let hint = format!("{} has the dimension {}", need.words, measure::powers_text(wanted));
            return f.refuse_with(node, message, hint);
        }
        let symbols = data.iter().filter(|i| own(**i).is_some());
        let uses = symbols.map(|datum| DatumUse { datum: *datum, need: *Need::TERM });
        self.met.borrow_mut().uses.extend(uses);
        let powers = |i: usize| {
            let given = || own(i)?.unit.as_ref().map(measure::powers);
            let powers = if i == self.gravity { Some(measure::own_powers("m/s^2")) } else { given() };
            powers.unwrap_or_default().map(|p| p / 4)
        };
        let formula = expression.formula().map(&mut |name| match name {
            Name::Datum(datum, degrees) => Given { datum, degrees, powers: powers(datum) },
            Name::Quantity(_) | Name::Next(_) => Given { datum: usize::MAX, degrees: false, powers: [0; 3] },
        });
        let number = Derived { formula, degrees: need.in_degrees(), text: text.to_owned(), any: false };
        if data.is_empty() {
            return self.constant(node, text, number.value(&[]), need);
        }
        let mut derived = self.derived.borrow_mut();
        let at = derived.iter().position(|d| *d == number).unwrap_or_else(|| {
            derived.push(number);
            derived.len() - 1
        });
        Some(Num::Derived(at))
    }

    /// A point, `[x, y]`.
    pub(super) fn place(&self, node: &Node) -> Option<[Num; 2]> {
        match &node.value {
            Value::List(xy) if xy.len() == 2 => {
                let [x, y] = [&xy[0], &xy[1]].map(|n| self.number(n, Need::PLACE));
                Some([x?, y?])
            }
            _ => {
                let message = format!("expected a place such as `[x_A, y_A]`, found {}", node.kind());
                self.faults.refuse(node, message)
            }
        }
    }

    pub(super) fn need_number(
        &self,
        fields: &mut Fields,
        name: &'static str,
        example: &'static str,
        need: &Need,
    ) -> Option<Num> {
        fields.need(name, example).and_then(|n| self.number(n, need))
    }

    /// A number that may be left out. `None`: given but wrong; `Some(None)`: left out.
    #[expect(clippy::option_option, reason = "left out and wrong are told apart")]
    pub(super) fn optional(
        &self,
        fields: &mut Fields,
        name: &'static str,
        need: &Need,
    ) -> Option<Option<Num>> {
        fields.get(name).map_or(Some(None), |n| self.number(n, need).map(Some))
    }

    /// As an expression names it: a datum or what is worked out from data; `None` for a constant with a unit.
    pub(super) fn named(&self, number: Num) -> Option<String> {
        match number {
            Num::Datum(i) => Some(self.symbols[i].name.clone()),
            Num::Derived(i) => {
                self.derived.borrow().get(i).filter(|d| !d.any).map(|d| format!("({})", d.text))
            }
            Num::Fixed(_) => None,
        }
    }

    /// A length over a pure number or another length, as the way or the angle at which a motion ends: the divisor, and whether it is
    /// a length that stands there without its unit.
    pub(super) fn over(&self, node: &Node, by: Option<(String, bool)>, need: &Need) -> Option<Num> {
        let text = node.text().map(str::trim)?;
        let known = is_expression(text) || self.symbols.iter().any(|s| s.name == text);
        // A text that is no number is a finding of the reader of numbers.
        let constant = if known { None } else { Some(self.number(node, Need::LENGTH)?) };
        let Some((by, bare)) = by else {
            return self.faults.refuse_with(
                node,
                "this length is divided by the radius on which the cord is wound, which is no datum",
                "make the radius a datum, such as `r: {name: radius, unit: m, draw: always 0.2}`",
            );
        };
        let over = match constant {
            Some(Num::Fixed(length_m)) => length_m.to_string(),
            _ if is_expression(text) => format!("({text})"),
            _ => text.to_owned(),
        };
        let metres = i32::from(bare) - i32::from(constant.is_some());
        let [mass, length, time] = measure::own_powers(need.unit);
        let wanted = [mass, length + metres * measure::own_powers("m")[1], time];
        self.derived(node, &format!("{over}/{by}"), need, wanted)
    }
}

/// Is it to be worked out, and no symbol alone and no constant with its unit (`4 kg*m^2`, `-2 m/s`)?
fn is_expression(text: &str) -> bool {
    let signless = text.trim_start_matches(one_of("-+")).trim_start();
    let number = |c: char| c.is_ascii_digit() || c == '.';
    if !signless.starts_with(number) {
        return text.contains(one_of("+-*/^(·"));
    }
    let rest = signless.trim_start_matches(number);
    // A power of ten belongs to the number.
    let ten = rest.strip_prefix(one_of("eE")).map(|r| r.trim_start_matches(one_of("+-")));
    let rest = match ten {
        Some(digits) if digits.starts_with(|c: char| c.is_ascii_digit()) => digits.trim_start_matches(number),
        _ => rest,
    };
    rest.trim_start().starts_with(one_of("+-*/^·"))
}
