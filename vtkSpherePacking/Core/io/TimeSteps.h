// SPDX-License-Identifier: BSD-3-Clause
#ifndef TimeSteps_h
#define TimeSteps_h

#include "io/PackingFormats.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace spherepacking
{
/// A time step of a file: the number that the file gives it, if any, the range of its bytes, and
/// its first line.
struct TimeStep
{
  std::optional<double> Time;
  unsigned long long Begin;
  unsigned long long End;
};

/// The numbers that a file gives a step, in order of preference, such as its time and its number.
using StepNumbers = std::array<std::optional<double>, 3>;

/// Sets the time of each step to the first of its numbers that increases from step to step; or else
/// to the first that all have, or that any has: LAMMPS writes the time with six decimals, which may
/// all be the same, beside the number of the time step.
void SetTimes(std::vector<TimeStep>& steps, const std::vector<StepNumbers>& numbers);

/// The steps of a file, at least one, and the value by which each is asked for: the file's own
/// numbers if all steps have one and these increase, else 0, 1, 2 and so on. A run that was
/// restarted may give a number twice.
struct TimeSteps
{
  explicit TimeSteps(std::vector<TimeStep> steps);

  /// The last step whose value is not after `value`; the first if all are, or without a value.
  std::size_t IndexOf(const std::optional<double>& value) const;

  std::vector<TimeStep> Steps;
  std::vector<double> Values;
};

/// Whether files of the format may hold several time steps.
bool HasSteps(Format format);

/// Finds the steps of `file`, one function per format that has them. A last step that was cut
/// before it says what it is, since the run was stopped, is left out if there are others.
std::vector<TimeStep> FindDumpSteps(const std::string& file, Progress& progress);
std::vector<TimeStep> FindXyzSteps(const std::string& file, Progress& progress);
std::vector<TimeStep> FindMercurySteps(const std::string& file, Progress& progress);
}

#endif
