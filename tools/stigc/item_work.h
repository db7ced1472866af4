// SPDX-License-Identifier: MIT
// Items of a study, shared out to whoever works: threads of this process, unless a program with
// other helpers says so.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "uses.h"

namespace stig::cli {

/// What an item comes to, in one line, by the line that names it; empty: the user asked to stop.
using DoItem = std::function<std::string(const std::string& item)>;
/// Takes lines that are done, one call at a time; false: no more can be taken.
using TakeLines = std::function<bool(const std::vector<std::string>& lines)>;

/// Does items in any order, and hands lines over a few times a second; returns when all that were
/// begun are handed over. False when they could not be, or when the user asked to stop.
using ShareOut = std::function<bool(const std::vector<std::string>& items, int threads,
                                    const DoItem& work, const TakeLines& take)>;

bool share_among_threads(const std::vector<std::string>& items, int threads, const DoItem& work,
                         const TakeLines& take);

/// Who does the items of this process's study. Those that lead may share out several times; those
/// that do not do so once, without items, and work until they are dismissed.
struct Workforce {
  ShareOut share = share_among_threads;
  bool leads = true;    ///< false: this process works for another, which keeps what is done
  bool others = false;  ///< other processes do the work
};
Workforce& workforce();

}  // namespace stig::cli
