// Prints what reports/results.schema.json must be.
#include <iostream>

#include "tests/reports/results_schema.h"

int main() { std::cout << zproof::results_schema(); }
