// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>

namespace testfiles
{
/** A file's content with a few bytes changed, added or removed, or its end. */
inline std::string Mutated(std::string text, std::mt19937& random)
{
  const std::size_t mutations = 1 + random() % 4;
  for (std::size_t i = 0; i < mutations && !text.empty(); ++i)
  {
    const std::size_t at = random() % text.size();
    const char any = static_cast<char>(random());
    const char digit = "0123456789-+.eE/ \n#\\"[random() % 20];
    switch (random() % 6)
    {
      case 0:
        text[at] = any;
        break;
      case 1:
        text[at] = digit;
        break;
      case 2:
        text.insert(at, 1, digit);
        break;
      case 3:
        text.erase(at, 1 + random() % 5);
        break;
      case 4:
        text[at] = static_cast<char>(text[at] ^ (1 << random() % 8));
        break;
      default:
        text.resize(random() % 8 == 0 ? at : text.size());
    }
  }
  return text;
}
} // namespace testfiles
