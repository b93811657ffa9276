"""The programs that are compared, one a file."""
