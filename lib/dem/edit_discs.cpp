#include "dem/edit_discs.hpp"

#include <limits>

#include "dem/neighbour_lists.hpp"

namespace ifedem {
namespace {

constexpr std::uint32_t gone = std::numeric_limits<std::uint32_t>::max();

/// New place of each old one, `gone` for what does not stay.
std::vector<std::uint32_t> close_gaps(const std::vector<char>& stays) {
    std::vector<std::uint32_t> place;
    std::uint32_t next = 0;
    for (const char s : stays) place.push_back(s != 0 ? next++ : gone);
    return place;
}

template <class T>
void keep(const std::vector<char>& stays, std::vector<T>& items) {
    if (items.empty()) return;
    std::size_t kept = 0;
    for (std::size_t n = 0; n < items.size(); ++n)
        if (stays[n] != 0) items[kept++] = items[n];
    items.resize(kept);
}

/// `stays` by list position.
void keep_pairs(const std::vector<char>& stays, PairState& p) {
    const std::vector<std::uint32_t> position = close_gaps(stays);
    std::vector<char> pair_stays(p.i.size());
    for (std::size_t n = 0; n < p.i.size(); ++n) pair_stays[n] = static_cast<char>(stays[p.i[n]] & stays[p.j[n]]);
    const std::vector<std::uint32_t> pair_place = close_gaps(pair_stays);
    std::vector<char> inner_stays;
    for (const std::uint32_t outer : p.inner) inner_stays.push_back(pair_stays[outer]);
    keep(inner_stays, p.tangential_m), keep(inner_stays, p.inner);
    keep(pair_stays, p.i), keep(pair_stays, p.j);
    for (std::uint32_t& outer : p.inner) outer = pair_place[outer];
    for (auto* list : {&p.i, &p.j})
        for (std::uint32_t& at : *list) at = position[at];
    keep(stays, p.reference), keep(stays, p.inner_reference);
}

void keep_contacts(const std::vector<std::uint32_t>& new_id, std::vector<BoundaryContact>& contacts) {
    std::erase_if(contacts, [&](const BoundaryContact& c) { return new_id[c.disc] == gone; });
    for (BoundaryContact& c : contacts) c.disc = new_id[c.disc];
}

}  // namespace

void keep_discs(const std::vector<char>& stays, State& state) {
    DiscState& discs = state.discs;
    std::vector<char> id_stays(discs.disc.size(), 0);
    for (std::size_t p = 0; p < stays.size(); ++p) id_stays[discs.id[p]] = stays[p];
    const std::vector<std::uint32_t> new_id = close_gaps(id_stays);
    keep_pairs(stays, state.pairs);
    for (auto* contacts :
         {&state.wall_contacts, &state.wheel_contacts, &state.soil.contacts, &state.soil.attached_contacts})
        keep_contacts(new_id, *contacts);
    keep(stays, discs.disc), keep(stays, discs.id), keep(stays, discs.acceleration);
    for (std::uint32_t& id : discs.id) id = new_id[id];
}

void edit_discs(const DemConstants& k, const std::vector<std::uint32_t>& remove, const std::vector<Disc>& add,
                State& state, DemWorkspace& work) {
    DiscState& discs = state.discs;
    std::vector<char> stays(discs.disc.size(), 1);
    for (const std::uint32_t p : remove) stays[p] = 0;
    keep_discs(stays, state);
    for (const Disc& d : add) {
        discs.id.push_back(static_cast<std::uint32_t>(discs.disc.size()));
        discs.disc.push_back(d);
        if (!discs.acceleration.empty()) discs.acceleration.emplace_back();
    }
    work.rebuild_outer = true;
    update_lists(k, state, work);
}

}  // namespace ifedem
