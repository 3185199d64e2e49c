// The three standard streams as the program finds them: closed, full, or read by nobody.
#pragma once

#include <string_view>

namespace gripscan::app {

/// Once, before anything is opened: a stream that is closed must not lend its number to a file of
/// a session or to a socket, which would then get what is said. Writing to it fails as before.
void keep_standard_streams();
/// As it stands, on standard error. Where nobody can read it the work goes on all the same.
void tell_people(std::string_view text);

}  // namespace gripscan::app
