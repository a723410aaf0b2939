// SPDX-License-Identifier: GPL-3.0-or-later
// A target needs a source file for the headers that it compiles for all tests of the window.
