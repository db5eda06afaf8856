"""Report: what was marked as data: the pages of the students, the summary of the class, the table of marks, and their folder."""
