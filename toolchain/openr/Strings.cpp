// SPDX-License-Identifier: Apache-2.0
// The parts of std::string that the compiler does not put where they are used, but expects in its
// library; the SDK's library is of 2003 and has another string. The linker keeps those that are
// used.
#include <string>

template class std::basic_string<char>;
