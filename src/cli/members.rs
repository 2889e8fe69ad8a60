//! Stands in for the reader of rosters until that is merged.
use crate::finding::Finding;
pub struct Student {
    pub id: String,
    pub name: String,
}
pub struct Roster {
    pub students: Vec<Student>,
}
impl Roster {
    pub fn folders(&self) -> Vec<String> {
        self.students.iter().map(|s| s.id.clone()).collect()
    }
}
pub fn read(bytes: &[u8], _file: &str) -> Result<Roster, Vec<Finding>> {
    let mut r = csv::Reader::from_reader(bytes);
    Ok(Roster {
        students: r
            .records()
            .flatten()
            .map(|r| Student { id: r[0].to_owned(), name: r.get(1).unwrap_or("").to_owned() })
            .collect(),
    })
}
pub fn escape_twin(s: &str) -> String {
    format!("{s}~")
}
