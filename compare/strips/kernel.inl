// The algorithms that all instruction sets share, and what becomes of them.

#include "compare/strips/columns.inl"

#include "compare/strips/certain.inl"
#include "compare/strips/ids.inl"
#include "compare/strips/runs.inl"
#include "compare/strips/signs.inl"
#include "compare/strips/squares.inl"
#include "compare/strips/tolerances.inl"

/// Made by the compiler: nothing of it may run before a processor is asked what it has.
consteval Kernel kernel_named(const char* name) {
    return {.name = name,
            .compare = compare,
            .certain = certain,
            .lawful = lawful,
            .where_shown = where_shown,
            .where_shown_in_tile = where_shown_in_tile,
            .certain_by_corners = certain_by_corners,
            .set_tolerances = set_tolerances,
            .set_signs = set_signs,
            .set_places = set_places};
}
