//! XML as it is written here: elements within elements, everything in them whole.
use quick_xml::Writer;
use quick_xml::events::{BytesCData, BytesDecl, BytesEnd, BytesStart, BytesText, Event};

/// Attributes: name, value.
pub type Attributes<'a> = &'a [(&'a str, &'a str)];

/// XML that is being written.
pub struct Xml {
    writer: Writer<Vec<u8>>,
}

impl Xml {
    /// A file of its own.
    pub fn file() -> Self {
        let mut xml = Self::piece();
        xml.write(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)));
        xml.line();
        xml
    }

    /// A piece of a file.
    pub fn piece() -> Self {
        Self { writer: Writer::new(Vec::new()) }
    }

    fn write(&mut self, event: Event) {
        self.writer.write_event(event).expect("memory takes what is written");
    }

    pub fn element(&mut self, name: &str, attributes: Attributes, inside: impl FnOnce(&mut Self)) {
        self.begin(name, attributes);
        inside(self);
        self.end(name);
    }

    /// The begin of an element.
    pub fn begin(&mut self, name: &str, attributes: Attributes) {
        self.write(Event::Start(start(name, attributes)));
    }

    pub fn end(&mut self, name: &str) {
        self.write(Event::End(BytesEnd::new(name)));
    }

    /// An element with nothing in it.
    pub fn empty(&mut self, name: &str, attributes: Attributes) {
        self.write(Event::Empty(start(name, attributes)));
    }

    /// An element with a text in it, which may hold anything.
    pub fn text(&mut self, name: &str, attributes: Attributes, text: &str) {
        self.element(name, attributes, |x| x.write(Event::Text(BytesText::new(&allowed(text)))));
    }

    /// The same as a section of character data, which is shorter where the text is HTML.
    pub fn data(&mut self, name: &str, attributes: Attributes, text: &str) {
        let text = allowed(text);
        self.element(name, attributes, |x| {
            BytesCData::escaped(&text).for_each(|section| x.write(Event::CData(section)));
        });
    }

    /// What is XML already.
    pub fn raw(&mut self, xml: &str) {
        self.writer.get_mut().extend_from_slice(allowed(xml).as_bytes());
    }

    /// A line ends.
    pub fn line(&mut self) {
        self.raw("\n");
    }

    pub fn done(self) -> String {
        String::from_utf8(self.writer.into_inner()).expect("text was written")
    }
}

fn start<'a>(name: &'a str, attributes: Attributes) -> BytesStart<'a> {
    let mut start = BytesStart::new(name);
    for (name, value) in attributes {
        // A reader of XML makes blanks of the ends of lines in an attribute, so they are blanks from the start.
        let value = allowed(value).replace(['\n', '\r', '\t'], " ");
        start.push_attribute((*name, value.as_str()));
    }
    start
}

/// A text without the characters that XML cannot hold in any way.
pub fn allowed(text: &str) -> String {
    let may = |c: &char| !c.is_control() || matches!(c, '\t' | '\n' | '\r' | '\u{7f}'..='\u{9f}');
    text.chars().filter(may).filter(|c| !matches!(c, '\u{fffe}' | '\u{ffff}')).collect()
}
