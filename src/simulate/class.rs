//! The class: ids and names as they occur, also those that are awkward as file names and in CSV.
use crate::csv_field::push_line;

/// Id and name.
#[rustfmt::skip] // a table
pub const STUDENTS: [(&str, &str); 24] = [
    ("0017", "Amina Yusuf"), ("0023", "Anders Ødegård"), ("0031", "Beatriz Conceição"),
    ("0044", "Bùi Thị Hạnh"), ("0058", "Chidi Okonkwo"), ("0062", "Daniel O'Brien"), ("0079", "Đặng Minh"),
    ("0085", "Elif Yılmaz"), ("0090", "Farida Haidari"), ("0101", "García Márquez, José"),
    ("0113", "Giulia D'Angelo"), ("0120", "Hana Nováková"), ("0136", "石川 さくら"), ("0142", "João Silva"),
    ("0157", "Kwame Mensah"), ("0163", "Lakshmi Subramaniam"), ("0178", "Liu Yang (刘洋)"),
    ("0184", "Marie-Claire Dubois"), ("0199", "Мария Иванова"), ("0205", "Nokuthula Dlamini"),
    ("0211", "Ólafur Þórsson"), ("0226", "Priya \"Pri\" Nair"), ("0233", "Tāne Ngata"),
    ("0248", "Zoë van der Berg"),
];

/// The roster as a CSV file.
pub fn roster() -> Vec<u8> {
    let mut out = b"student,name\n".to_vec();
    for (id, name) in STUDENTS {
        push_line(&mut out, [id, name]);
    }
    out
}
