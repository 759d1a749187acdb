# SPDX-License-Identifier: Apache-2.0
"""A black box theatre with a white cyclorama; tools/make_theatre.py puts it together. Python's own library only."""
