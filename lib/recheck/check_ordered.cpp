// SPDX-License-Identifier: MIT
// Column by column, without a list of structures (docs/proofs.md, "Robots' work").
//
// Whatever stands has with a brick all that come before it. So what is in sight of a column, there
// or missing, leaves the rest between the least that must stand then and the most that can.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "recheck/work_site.h"

namespace stig::recheck {

namespace {

class Ordered {
 public:
  Ordered(WorkSite& site, WorkReport& report)
      : site_(site), whole_(site.whole), report_(report), start_(whole_.start()) {}

  std::string check() {
    order();
    look_everywhere();
    go_on();
    if (site_.certificate.crowd != WorkCrowd::one) {
      for (const Deed& deed : deeds_) last(deed);
      keep_ways_out();
    }
    return refusal_;
  }

 private:
  void refuse(const std::string& why) {
    if (refusal_.empty()) refusal_ = why;
  }

  /// A brick comes after those with lower numbers alone, so there is no circle.
  void order() {
    const std::size_t n = whole_.size();
    below_.assign(n, Bricks(n));
    above_.assign(n, Bricks(n));
    for (std::size_t i = 0; i < n; ++i) {
      if (i >= site_.certificate.start) below_[i].add(start_);
      below_[i].add(i);
      for (const std::uint32_t one : site_.certificate.bricks[i].after) below_[i].add(below_[one]);
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k <= i; ++k) {
        if (below_[i].has(k)) above_[k].add(i);
      }
    }
  }

  /// Calls `visit` for what can stand about a column that is the foremost of its row, with all of
  /// `given`, which is closed, and none of `missing`, which has all that come after what it has.
  using Visit = std::function<void(const Range&)>;
  void each(const Before& at, const Bricks& given, Bricks missing, const Visit& visit) {
    for (const std::uint32_t one : in_front(at)) missing.add(above_[one]);
    if (missing.meets(given)) return;
    std::vector<std::uint32_t> about;
    for (const NearCell& c : site_.view.cells()) {
      const std::uint32_t one = whole_.at(at.side, {at.u + c.du, at.v + c.dv, c.z});
      if (one != kNoBrick) about.push_back(one);
    }
    std::sort(about.begin(), about.end());
    extend(at, about, 0, given, missing, visit);
  }

  void extend(const Before& at, const std::vector<std::uint32_t>& about, std::size_t next,
              const Bricks& sure, const Bricks& missing, const Visit& visit) {
    if (!refusal_.empty()) return;
    while (next < about.size() && (sure.has(about[next]) || missing.has(about[next]))) ++next;
    if (next == about.size()) {
      if (!stands(at, sure)) return;
      if (++report_.situations > kMostSituations) return refuse("too many situations to look at");
      Range range{sure, Bricks(whole_.size())};
      for (std::size_t i = 0; i < whole_.size(); ++i) {
        if (!missing.has(i)) range.maybe.add(i);
      }
      return visit(range);
    }
    Bricks more = sure;
    more.add(below_[about[next]]);
    extend(at, about, next + 1, more, missing, visit);
    more = missing;
    more.add(above_[about[next]]);
    extend(at, about, next + 1, sure, more, visit);
  }

  bool stands(const Before& at, const Bricks& some) const {
    for (int z = 0; z < whole_.levels(); ++z) {
      const std::uint32_t one = whole_.at(at.side, {at.u, at.v, z});
      if (one != kNoBrick && some.has(one)) return true;
    }
    return false;
  }

  /// Robots come to a column when nothing stands before it, and next to that at most by one cell.
  const std::vector<std::uint32_t>& in_front(const Before& at) {
    const auto [known, added] = in_front_.try_emplace({at.side, at.u, at.v});
    if (!added) return known->second;
    for (std::uint32_t i = 0; i < whole_.size(); ++i) {
      const Seen brick = whole_.seen(at.side, i);
      const int across = std::abs(brick.v - at.v);
      if (across <= 1 && brick.u > at.u + across) known->second.push_back(i);
    }
    return known->second;
  }

  void look_everywhere() {
    const Bricks none(whole_.size());
    for (const int side : site_.certificate.sides) {
      std::set<std::pair<int, int>> columns;
      for (std::size_t i = 0; i < whole_.size(); ++i) {
        columns.emplace(whole_.seen(side, i).u, whole_.seen(side, i).v);
      }
      for (const auto& [u, v] : columns) {
        const Before at{side, u, v};
        each(at, start_, none, [&](const Range& there) { look(at, there); });
      }
    }
  }

  void look(const Before& at, const Range& there) {
    const auto put = site_.wish(at, there.sure);
    if (!put) return;
    std::string why;
    const std::uint32_t brick = site_.meant(at, *put, there, why);
    if (brick == kNoBrick) return refuse(why);
    Bricks before = below_[brick];
    before.remove(brick);
    if (!there.sure.holds(before)) {
      return refuse(site_.name(brick) + " is put where not all is certain to stand before it");
    }
    deeds_.insert({brick, at.side});
  }

  /// The first brick that is missing can be put, whatever else stands.
  void go_on() {
    Bricks before = start_;
    for (std::size_t i = site_.certificate.start; i < whole_.size() && refusal_.empty(); ++i) {
      const WorkBrick& one = site_.certificate.bricks[i];
      const Seen place = whole_.seen(one.side, i);
      const Before at{one.side, place.u + one.column.du, place.v + one.column.dv};
      if (!comes(at, i, before)) {
        return refuse(site_.name(static_cast<std::uint32_t>(i)) +
                      " has a column to which robots may not come");
      }
      each(at, before, above_[i], [&](const Range& there) {
        if (site_.wish(at, there.sure)) return;
        refuse("nothing may be left to be done before " +
               site_.name(static_cast<std::uint32_t>(i)));
      });
      before.add(i);
    }
  }

  bool comes(const Before& at, std::size_t missing, const Bricks& before) {
    const auto& sides = site_.certificate.sides;
    if (std::find(sides.begin(), sides.end(), at.side) == sides.end()) return false;
    const std::vector<std::uint32_t>& front = in_front(at);
    return stands(at, before) && std::all_of(front.begin(), front.end(), [&](std::uint32_t one) {
             return above_[missing].has(one);
           });
  }

  /// What is decided stays right and within reach, whatever others put until it is done.
  void last(const Deed& deed) {
    Range range{below_[deed.brick], Bricks(whole_.size())};
    range.sure.remove(deed.brick);
    for (std::size_t i = 0; i < whole_.size(); ++i) {
      if (!above_[deed.brick].has(i)) range.maybe.add(i);
    }
    if (const std::string why = site_.fault(deed, range); !why.empty()) {
      refuse("when others have put theirs, " + why);
    }
  }

  void keep_ways_out() {
    for (const Deed& deed : deeds_) {
      Bricks sure = below_[deed.brick];
      sure.remove(deed.brick);
      Seen stand = whole_.seen(deed.side, deed.brick);
      stand.z = 0;
      keep_way_out(deed.side, stand, sure, {});
    }
    // Before any column that has a brick: to put one on it, or in front of it.
    for (const int side : site_.certificate.sides) {
      for (std::size_t i = 0; i < whole_.size() && refusal_.empty(); ++i) {
        const Seen at = whole_.seen(side, i);
        const std::vector<std::uint32_t>& missing = in_front({side, at.u, at.v});
        for (const int u : {at.u, at.u + 1}) {
          keep_way_out(side, {u, at.v, 0}, below_[i], missing);
        }
      }
    }
  }

  /// May a robot other than the one on this side put the brick?
  bool others_put(std::uint32_t brick, int side) const {
    if (site_.certificate.crowd == WorkCrowd::any) return true;
    return std::any_of(deeds_.begin(), deeds_.end(),
                       [&](const Deed& deed) { return deed.brick == brick && deed.side != side; });
  }

  /// No brick can be due behind a robot that stands there, when `sure` does and `missing` do not.
  void keep_way_out(int side, const Seen& stand, const Bricks& sure,
                    const std::vector<std::uint32_t>& missing) {
    Bricks free = site_.room.lane(side, stand);
    const Bricks lane = free;
    for (const std::uint32_t one : missing) free.add(one);
    if (sure.meets(free)) return;  // no robot stands there
    for (std::uint32_t i = 0; i < whole_.size(); ++i) {
      if (!lane.has(i) || !site_.room.behind(stand, whole_.seen(side, i))) continue;
      if (!others_put(i, side)) continue;
      Bricks before = below_[i];
      before.remove(i);
      if (!before.meets(free)) return refuse(site_.name(i) + " may shut a robot in");
    }
  }

  WorkSite& site_;
  const Whole& whole_;
  WorkReport& report_;
  const Bricks start_;
  std::vector<Bricks> below_, above_;  ///< by brick, itself among them
  std::map<std::array<int, 3>, std::vector<std::uint32_t>> in_front_;
  std::set<Deed> deeds_;
  std::string refusal_;
};

}  // namespace

std::string check_ordered(WorkSite& site, WorkReport& report) {
  return Ordered(site, report).check();
}

}  // namespace stig::recheck
