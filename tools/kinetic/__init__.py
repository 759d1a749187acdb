# SPDX-License-Identifier: Apache-2.0
"""A stage on which everything travels: for tools/make_kinetic.py and tools/kinetic_places.py."""
