"""Paper: a picture as a few kinds of marks, where its labels go, and the formats that write it; no mechanics."""
