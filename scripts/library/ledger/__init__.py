"""The accuracy ledger: what tools/verify measures, against what, and how it writes it down."""
