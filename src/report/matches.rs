//! Wrong answers that are the right ones of a classmate, as the instructor is told of them; never for students.
use crate::csv_field::push_line;
use crate::matches;
use crate::num::shown;
use crate::words::Words;

/// A pair, in words.
#[derive(Debug, Clone, PartialEq)]
pub struct MatchedPair {
    /// Who gave the answers: id and name.
    pub student: [String; 2],
    /// Whose keys they hit: id and name.
    pub classmate: [String; 2],
    /// Parts, such as `1.omega`.
    pub parts: Vec<String>,
    /// The answers, as handed in.
    pub answers: Vec<String>,
    /// The chance that luck makes answers as fine as these hit this classmate's keys so well.
    pub chance: f64,
    /// How many pairs as striking luck brings in the whole class.
    pub expected: f64,
    /// Is it to be looked at?
    pub flagged: bool,
    /// What explains the answers otherwise, such as `1.omega: A05`; empty if nothing does.
    pub explained: String,
}

/// What was found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ClassMatches {
    /// Most striking first.
    pub pairs: Vec<MatchedPair>,
    /// Wrong answers in numbers that were held against classmates' keys.
    pub answers: usize,
    /// How many of those nothing else explains.
    pub unexplained: usize,
}

impl ClassMatches {
    /// What was looked at, what was found, and what luck brings.
    pub fn summary(&self, words: &Words) -> String {
        let flagged = self.pairs.iter().filter(|p| p.flagged).count();
        let (answers, unexplained) = (self.answers.to_string(), self.unexplained.to_string());
        let name = match self.answers {
            0 => return words.get("report.matches.nothing").to_owned(),
            1 => "report.matches.looked_one",
            _ => "report.matches.looked",
        };
        let looked = words.say(name, &[("n", &answers), ("unexplained", &unexplained)]);
        let name = match flagged {
            0 => "report.matches.found_none",
            1 => "report.matches.found_one",
            _ => "report.matches.found",
        };
        let found = words.say(name, &[("looked", &looked), ("n", &flagged.to_string())]);
        if self.unexplained == 0 {
            return found;
        }
        let one_in = shown::decimals(1.0 / matches::FLAGGED, 0);
        format!("{found} {}", words.say("report.matches.luck", &[("n", &one_in)]))
    }

    /// matches.csv: all pairs.
    pub fn csv(&self) -> Vec<u8> {
        let header = "look,student,classmate,parts,answers,chance,expected_by_luck,other_explanation\n";
        let mut out = header.as_bytes().to_vec();
        for pair in &self.pairs {
            let fields = [
                if pair.flagged { "yes" } else { "" },
                &pair.student[0],
                &pair.classmate[0],
                &pair.parts.join(" "),
                &pair.answers.join(" | "),
                &shown::figures(pair.chance, 2),
                &shown::figures(pair.expected, 2),
                &pair.explained,
            ];
            push_line(&mut out, fields);
        }
        out
    }
}
