// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cuts a long loop over rows into waves, between which one can ask whether to go on. Internal.
#ifndef dggRowWaves_h
#define dggRowWaves_h

#include "dggTypes.h" // for Id

#include <algorithm> // for std::min
#include <chrono>    // for the clock

namespace dgg
{
/// Waves of as many rows as take about a fifth of a second, going by the one before.
class RowWaves
{
public:
  static constexpr Id Smallest = 256;
  static constexpr Id Largest = 65536;

  explicit RowWaves(Id numberOfRows)
    : Rows(numberOfRows)
    , Last(std::min(numberOfRows, Smallest))
    , Start(Clock::now())
  {
  }

  bool IsDone() const { return this->First >= this->Rows; }
  /// The rows of the wave in hand: [first, last).
  Id GetFirst() const { return this->First; }
  Id GetLast() const { return this->Last; }
  /// Of all rows, with those of the wave in hand.
  double GetShareDone() const { return static_cast<double>(this->Last) / this->Rows; }

  /// On to the next wave, which is not to have more than `most` rows.
  void Advance(double most = Largest)
  {
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - this->Start).count();
    const double rate = (this->Last - this->First) / std::max(seconds, 1e-6);
    const double wanted = std::min(std::min(rate * Seconds, most), static_cast<double>(Largest));
    const Id rows = static_cast<Id>(std::max(wanted, LeastRows));
    this->First = this->Last;
    this->Last += std::min(this->Rows - this->Last, rows);
    this->Start = now;
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr double Seconds = 0.2;
  static constexpr double LeastRows = 64.0;

  Id Rows;
  Id First = 0;
  Id Last;
  Clock::time_point Start;
};
}

#endif
