// SPDX-License-Identifier: GPL-3.0-or-later

// Read by the leak sanitizer, where it is on: Open CASCADE keeps some 3 kB once per process,
// however many files are written.
extern "C" const char* __lsan_default_suppressions() { return "leak:libTK\n"; }
