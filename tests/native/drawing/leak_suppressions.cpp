// SPDX-License-Identifier: GPL-3.0-or-later

// Read by the leak sanitizer, where it is on: Cairo's fonts come from Fontconfig, which keeps its
// patterns until the process ends.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
