// SPDX-License-Identifier: BSD-3-Clause
#include "io/PackingFormats.h"

#include "io/EsysSnapshot.h"
#include "io/FileBytes.h"
#include "io/LammpsDataFile.h"
#include "io/LineCursor.h"
#include "io/MercuryHeader.h"
#include "io/FixedForms.h"
#include "io/PackingFileError.h"
#include "io/TextChunks.h"
#include "io/UnicodeText.h"
#include "io/Utf8Mark.h"
#include "io/XyzComment.h"

#include "vtksys/SystemTools.hxx"

#include <map>
#include <string_view>

namespace spherepacking
{
namespace
{
bool BeginsWith(std::string_view text, std::string_view prefix)
{
  return text.substr(0, prefix.size()) == prefix;
}

// The end of the last line that is whole, if there are more bytes than the first `length`.
const char* WholeLinesEnd(const FileBytes& head, unsigned long long length)
{
  const char* end = head.End();
  if (static_cast<unsigned long long>(end - head.Begin()) == length)
  {
    while (end != head.Begin() && !IsLineEnd(end[-1]))
    {
      --end;
    }
  }
  return end == head.Begin() ? head.End() : end;
}

// Detects the format by what the first lines begin with, up to one that is no comment. Only YADE
// writes #format.
Format FormatOfText(const char* begin, const char* end)
{
  LineFinder find(end);
  for (const char* p = begin; p != end;)
  {
    const char* lineEnd = find(p);
    const char* first = SkipBlanks(p, lineEnd);
    const std::string_view line(first, lineEnd - first);
    if (BeginsWith(line, "ITEM:"))
    {
      return Format::Dump;
    }
    if (BeginsWith(line, "#format"))
    {
      return Format::Yade;
    }
    if (!line.empty() && line.front() != '#')
    {
      break;
    }
    p = SkipLineEnd(lineEnd, end);
  }
  return Format::Spheres;
}

// Whether a text begins with a count, and a comment that `accepts` takes.
template <typename Accepts>
bool BeginsAsXyz(const char* begin, const char* end, const Accepts& accepts)
{
  LineCursor lines({ begin, end });
  while (lines.Step() && lines.Fields().empty())
  {
  }
  return XyzCount(lines.Line()) && lines.Step() && accepts(lines.Line());
}

// Whether a text begins as LAMMPS's dump yaml.
bool BeginsAsYamlDump(const char* begin, const char* end)
{
  LineCursor lines({ begin, end });
  return lines.Step() && BeginsWith(lines.Line(), "---") && lines.Step() &&
    BeginsWith(lines.Line(), "creator: LAMMPS");
}

// Detects the formats of simulation programs by lines that no table begins with.
Format FormatOfProgram(const std::string& file, const char* begin, const char* end)
{
  begin = SkipUtf8Mark(begin, end);
  if (BeginsAsYamlDump(begin, end))
  {
    ThrowInFile(file,
      LineError(1, "found a dump of LAMMPS in YAML, expected one in text, as dump custom writes"));
  }
  using vtksys::SystemTools;
  const std::string extension = SystemTools::LowerCase(SystemTools::GetFilenameLastExtension(file));
  const bool isXyz = extension == ".xyz" || extension == ".extxyz" || extension == ".exyz";
  const auto hasProperties = [isXyz](std::string_view comment)
  { return isXyz || XyzComment(comment).Properties(); };
  return BeginsAsXyz(begin, end, hasProperties) ? Format::Xyz
    : BeginsAsLammpsData(begin, end)            ? Format::LammpsData
    : BeginsAsMercury(begin, end)               ? Format::Mercury
    : BeginsAsEsysSnapshot(begin, end)          ? Format::EsysSnapshot
                                                : Format::Spheres;
}
}

//------------------------------------------------------------------------------
Format FormatOfExtension(const std::string& file)
{
  static const std::map<std::string, Format> formats{ { ".spheres", Format::Spheres },
    { ".xyzr", Format::Xyzr }, { ".csv", Format::Csv }, { ".xyzd", Format::Xyzd },
    { ".dump", Format::Dump }, { ".lammpstrj", Format::Dump }, { ".liggghts", Format::Dump },
    { ".pqr", Format::Pqr }, { ".sph", Format::SphereTree }, { ".swc", Format::Swc },
    { ".eswc", Format::Swc }, { ".geo", Format::GenGeo }, { ".ma", Format::MedialAxis },
    { ".mdpa", Format::Kratos } };
  const auto found = formats.find(
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file)));
  return found == formats.end() ? Format::Auto : found->second;
}

//------------------------------------------------------------------------------
Format GuessFormat(const std::string& file)
{
  const Format format = FormatOfExtension(file);
  if (format != Format::Auto && format != Format::SphereTree)
  {
    return format;
  }
  constexpr unsigned long long length = 1 << 16;
  const FileBytes bytes = FileBytes::ReadHead(file, length);
  if (HasWideMark(bytes))
  {
    return format == Format::Auto ? Format::Spheres : format; // no program writes UTF-16
  }
  const TextRange head{ SkipUtf8Mark(bytes.Begin(), bytes.End()), WholeLinesEnd(bytes, length) };
  const Format ofText = FormatOfText(head.Begin, head.End);
  const Format fixed = ofText == Format::Spheres ? GuessFixedForm(head) : Format::Auto;
  if (format == Format::SphereTree)
  {
    // Other programs write dumps or spheres of molecules with the extension .sph.
    return ofText == Format::Dump                      ? ofText
      : fixed == Format::Dock || fixed == Format::Hole ? fixed
                                                       : format;
  }
  if (fixed != Format::Hole)
  {
    RefuseAtomsWithoutRadii(file, head);
  }
  if (fixed != Format::Auto)
  {
    return fixed;
  }
  return ofText == Format::Spheres ? FormatOfProgram(file, bytes.Begin(), bytes.End()) : ofText;
}

//------------------------------------------------------------------------------
void ThrowNoSphere(const std::string& expected)
{
  throw ContentError("holds no sphere, expected " + expected);
}
}
