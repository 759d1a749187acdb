# SPDX-License-Identifier: Apache-2.0
"""A festival rig of any size, module by module; tools/make_festival.py puts it together. Python's own library only."""
