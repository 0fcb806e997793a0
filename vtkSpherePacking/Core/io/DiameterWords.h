// SPDX-License-Identifier: BSD-3-Clause
#ifndef DiameterWords_h
#define DiameterWords_h

#include <string_view>

namespace spherepacking
{
/**
 * Whether a remark may speak of diameters: by a word for them or a sign, by "2r", or by a d that
 * stands alone. A d that is clearly something else does not count: "3-d", "d = 0.5", "J. D. Smith",
 * "Appendix D", a path or a format of printf.
 */
bool SpeaksOfDiameter(std::string_view remark);
}

#endif
