// SPDX-License-Identifier: BSD-3-Clause
#ifndef Separators_h
#define Separators_h

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace spherepacking
{
/**
 * Splits lines into fields. Every function stops at a line end at the latest, so the text must have
 * one.
 */
class Separators
{
public:
  /// Fields are separated by blanks, with at most one comma or semicolon among them; # begins a
  /// comment, which counts as the end of the line.
  static Separators Liberal() { return Separators(0); }

  /// Fields are separated by exactly one `delimiter`, may be empty and may be in double quotes.
  static Separators Strict(char delimiter) { return Separators(delimiter); }

  /// Fields are separated by blanks alone, and there are no comments.
  static Separators Blanks()
  {
    Separators blanks(0);
    blanks.At(',') = blanks.At(';') = blanks.At('#') = Kind::Other;
    return blanks;
  }

  bool IsStrict() const { return this->Strictly; }
  bool IsBlank(char c) const { return this->Of(c) == Kind::Blank; }
  bool IsDelimiter(char c) const { return this->Of(c) == Kind::Delimiter; }
  bool EndsLine(char c) const { return this->Of(c) == Kind::End; }
  bool EndsNumber(char c) const { return this->Of(c) != Kind::Other; }

  const char* SkipBlanks(const char* p) const
  {
    while (this->IsBlank(*p))
    {
      ++p;
    }
    return p;
  }

  /// The end of the field that begins at `p`, trailing blanks not counted.
  const char* FieldEnd(const char* p) const
  {
    if (!this->Strictly)
    {
      while (!this->EndsNumber(*p))
      {
        ++p;
      }
      return p;
    }
    const char* last = p;
    for (bool quoted = false; !this->EndsLine(*p) && (quoted || !this->IsDelimiter(*p)); ++p)
    {
      quoted ^= *p == '"';
      last = this->IsBlank(*p) ? last : p + 1;
    }
    return last;
  }

  /// A field without its quotes.
  std::string_view Unquote(std::string_view field) const
  {
    const bool quoted =
      this->Strictly && field.size() >= 2 && field.front() == '"' && field.back() == '"';
    return quoted ? field.substr(1, field.size() - 2) : field;
  }

  /// All fields of the line at `p`, without their quotes.
  std::vector<std::string_view> Split(const char* p) const
  {
    std::vector<std::string_view> fields;
    p = this->SkipBlanks(p);
    while (!this->EndsLine(*p))
    {
      const char* end = this->FieldEnd(p);
      fields.push_back(this->Unquote({ p, static_cast<std::size_t>(end - p) }));
      p = this->SkipBlanks(end);
      if (this->IsDelimiter(*p))
      {
        p = this->SkipBlanks(p + 1);
      }
    }
    return fields;
  }

private:
  enum class Kind : unsigned char
  {
    Other,
    Blank,
    Delimiter,
    End
  };

  explicit Separators(char delimiter)
    : Strictly(delimiter != 0)
  {
    this->At(' ') = this->At('\t') = Kind::Blank;
    this->At('\n') = this->At('\r') = Kind::End;
    if (this->Strictly)
    {
      this->At(delimiter) = Kind::Delimiter;
    }
    else
    {
      this->At(',') = this->At(';') = Kind::Delimiter;
      this->At('#') = Kind::End;
    }
  }

  Kind& At(char c) { return this->Kinds[static_cast<unsigned char>(c)]; }
  Kind Of(char c) const { return this->Kinds[static_cast<unsigned char>(c)]; }

  std::array<Kind, 256> Kinds{};
  bool Strictly;
};
}

#endif
