//! A reader of XML for tests: the whole file as a tree, and a fault where it is not well-formed.
#![allow(dead_code, reason = "each program of tests takes what it needs")]
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

/// An element with all that is in it.
#[derive(Debug, Clone, Default)]
pub struct Node {
    pub name: String,
    pub attributes: Vec<(String, String)>,
    pub children: Vec<Node>,
    /// Text of the element itself and of those within, in order.
    pub text: String,
}

impl Node {
    fn begun(start: &BytesStart) -> Self {
        let attributes = start.attributes().map(|a| {
            let a = a.expect("an attribute");
            let value = a.normalized_value(XmlVersion::Explicit1_0).expect("a value");
            (a.key.as_ref().to_owned(), value.into_owned())
        });
        let attributes: Vec<(String, String)> = attributes.collect();
        for (i, (name, _)) in attributes.iter().enumerate() {
            assert!(attributes[..i].iter().all(|(n, _)| n != name), "{name} twice");
        }
        Self { name: start.name().as_ref().to_owned(), attributes, ..Self::default() }
    }

    /// The value of an attribute.
    pub fn get(&self, name: &str) -> &str {
        let found = self.attributes.iter().find(|(n, _)| n == name);
        found.map_or_else(|| panic!("{} has no {name}", self.name), |(_, value)| value)
    }

    /// The elements of this name anywhere within, in order.
    pub fn all(&self, name: &str) -> Vec<&Node> {
        let mut found = Vec::new();
        for child in &self.children {
            if child.name == name {
                found.push(child);
            }
            found.extend(child.all(name));
        }
        found
    }

    /// The first of them.
    pub fn one(&self, name: &str) -> &Node {
        self.all(name).first().copied().unwrap_or_else(|| panic!("no {name} in {}", self.name))
    }

    /// The number that is its text.
    pub fn number(&self) -> f64 {
        self.text.parse().unwrap_or_else(|_| panic!("{} holds {:?}", self.name, self.text))
    }
}

/// The root of a file, whose text must be well-formed XML and hold nothing that XML cannot hold.
pub fn read(text: &str) -> Node {
    let odd = |c: char| c.is_control() && !matches!(c, '\t' | '\n' | '\r' | '\u{7f}'..='\u{9f}');
    assert!(!text.contains(odd), "a character that is none in XML");
    let mut reader = Reader::from_str(text);
    reader.config_mut().check_end_names = true;
    let mut open = vec![Node::default()];
    loop {
        let event = reader.read_event().unwrap_or_else(|e| panic!("{e} at {}", reader.error_position()));
        let put =
            |open: &mut Vec<Node>, text: &str| open.iter_mut().for_each(|node| node.text.push_str(text));
        match event {
            Event::Start(start) => open.push(Node::begun(&start)),
            Event::Empty(start) => {
                let node = Node::begun(&start);
                open.last_mut().expect("a root").children.push(node);
            }
            Event::End(_) => {
                let node = open.pop().expect("an element that is open");
                open.last_mut().expect("a root").children.push(node);
            }
            Event::Text(text) => put(&mut open, &text),
            Event::CData(text) => put(&mut open, &text),
            Event::GeneralRef(entity) => {
                let meant = match (&*entity, entity.resolve_char_ref().expect("a character")) {
                    (_, Some(c)) => c.to_string(),
                    ("lt", _) => "<".to_owned(),
                    ("gt", _) => ">".to_owned(),
                    ("amp", _) => "&".to_owned(),
                    ("quot", _) => "\"".to_owned(),
                    ("apos", _) => "'".to_owned(),
                    (name, _) => panic!("XML has no entity {name}"),
                };
                put(&mut open, &meant);
            }
            Event::Eof => break,
            Event::Decl(_) | Event::Comment(_) | Event::PI(_) | Event::DocType(_) => {}
        }
    }
    assert_eq!(open.len(), 1, "an element is not closed");
    assert_eq!(open[0].children.len(), 1, "one root");
    open.remove(0).children.remove(0)
}

/// HTML in a text, as it would stand in a page.
pub fn html(text: &str) -> Node {
    read(&format!("<body>{text}</body>"))
}
