"""Pages that go along with two books, and problem sheets."""
