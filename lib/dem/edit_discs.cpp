#include "dem/edit_discs.hpp"

#include <limits>

#include "dem/neighbour_lists.hpp"

namespace ifedem {
namespace {

constexpr std::uint32_t gone = std::numeric_limits<std::uint32_t>::max();

/// Where each old place goes, or `gone`.
std::vector<std::uint32_t> close_gaps(const std::vector<char>& removed) {
    std::vector<std::uint32_t> place;
    std::uint32_t next = 0;
    for (const char r : removed) place.push_back(r != 0 ? gone : next++);
    return place;
}

template <class T>
void keep(const std::vector<char>& removed, std::vector<T>& items) {
    std::size_t kept = 0;
    for (std::size_t n = 0; n < items.size(); ++n)
        if (removed[n] == 0) items[kept++] = items[n];
    items.resize(kept);
}

/// What stays of the inner list becomes the whole list; the rebuild finds the rest.
void keep_pairs(const std::vector<std::uint32_t>& place, PairState& pairs) {
    PairState kept;
    for (std::size_t n = 0; n < pairs.inner.size(); ++n) {
        const std::uint32_t i = place[pairs.i[pairs.inner[n]]], j = place[pairs.j[pairs.inner[n]]];
        if (i == gone || j == gone) continue;
        kept.inner.push_back(static_cast<std::uint32_t>(kept.i.size()));
        kept.i.push_back(i), kept.j.push_back(j);
        kept.tangential_m.push_back(pairs.tangential_m[n]);
    }
    kept.reference = std::move(pairs.reference), kept.inner_reference = std::move(pairs.inner_reference);
    pairs = std::move(kept);
}

void keep_contacts(const std::vector<std::uint32_t>& new_id, std::vector<BoundaryContact>& contacts) {
    std::erase_if(contacts, [&](const BoundaryContact& c) { return new_id[c.disc] == gone; });
    for (BoundaryContact& c : contacts) c.disc = new_id[c.disc];
}

}  // namespace

void edit_discs(const DemConstants& k, const std::vector<std::uint32_t>& remove, const std::vector<Disc>& add,
                State& state, DemWorkspace& work) {
    DiscState& discs = state.discs;
    std::vector<char> removed(discs.disc.size(), 0), id_removed(discs.disc.size(), 0);
    for (const std::uint32_t p : remove) removed[p] = id_removed[discs.id[p]] = 1;
    const std::vector<std::uint32_t> place = close_gaps(removed), new_id = close_gaps(id_removed);

    keep_pairs(place, state.pairs);
    for (auto* contacts :
         {&state.wall_contacts, &state.wheel_contacts, &state.soil.contacts, &state.soil.attached_contacts})
        keep_contacts(new_id, *contacts);
    keep(removed, discs.disc), keep(removed, discs.id);
    if (!discs.acceleration.empty()) keep(removed, discs.acceleration);
    for (auto* reference : {&state.pairs.reference, &state.pairs.inner_reference}) keep(removed, *reference);
    for (std::uint32_t& id : discs.id) id = new_id[id];
    for (const Disc& d : add) {
        discs.id.push_back(static_cast<std::uint32_t>(discs.disc.size()));
        discs.disc.push_back(d);
        if (!discs.acceleration.empty()) discs.acceleration.emplace_back();
    }
    work.rebuild_outer = true;
    update_lists(k, state, work);
}

}  // namespace ifedem
