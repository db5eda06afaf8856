"""The programs that people would use instead, each as its documentation recommends; and ours, as anyone would call it."""
