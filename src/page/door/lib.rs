//! The functions that a page calls: texts go in and out through the memory that both see.
use slipstick::page::session::Session;
use std::cell::RefCell;

thread_local! {
    static SESSION: RefCell<Option<Session>> = const { RefCell::new(None) };
    /// The request that the page writes, and the answer that it reads.
    static TEXT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Makes room for a request of so many bytes, and says where.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    TEXT.with_borrow_mut(|text| {
        text.clear();
        text.resize(length, 0);
        text.as_mut_ptr()
    })
}

/// Where the answer stands.
#[unsafe(no_mangle)]
pub extern "C" fn place() -> *const u8 {
    TEXT.with_borrow(|text| text.as_ptr())
}

/// Opens the sheet that was written; gives the length of an answer, `null` or what is wrong.
#[unsafe(no_mangle)]
pub extern "C" fn open() -> usize {
    tell(|request| match Session::open(request) {
        Ok(session) => {
            SESSION.set(Some(session));
            "null".to_owned()
        }
        Err(fault) => fault.to_string(),
    })
}

/// Answers the request that was written; gives the length of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> usize {
    tell(|request| {
        SESSION.with_borrow(|session| {
            session.as_ref().map_or_else(|| "null".to_owned(), |session| session.answer(request))
        })
    })
}

fn tell(answer: impl FnOnce(&str) -> String) -> usize {
    TEXT.with_borrow_mut(|text| {
        *text = answer(&String::from_utf8_lossy(text)).into_bytes();
        text.len()
    })
}
