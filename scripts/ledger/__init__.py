"""The accuracy ledger: what scripts/verify measures, against what, and how it writes it down."""
