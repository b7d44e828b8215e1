#include "proof/mutations.h"

void mutations_list(Mutants *mutants, const Source *source) {
    mutations_of_numbers(mutants, source);
    mutations_of_operators(mutants, source);
    mutations_of_names(mutants, source);
    mutations_of_variables(mutants, source);
    mutations_of_statements(mutants, source);
    mutations_of_calls(mutants, source);
}
