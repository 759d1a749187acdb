# SPDX-License-Identifier: Apache-2.0
"""The demo stage, module by module; tools/make_demo_stage.py puts it together inside Blender."""
