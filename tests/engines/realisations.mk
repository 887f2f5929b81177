# One realisation: bed and lug phase are the case's own.
