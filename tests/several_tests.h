// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_several_tests_h
#define tests_several_tests_h

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

// What makes several tests one program (tests_together.cmake).

/// In the namespace of a test, its main() becomes run(). Only a main() outside
/// of namespaces may end without a value.
#define main(...)                \
  declared_as_main(__VA_ARGS__); \
  void run(__VA_ARGS__)

/// Runs the test of the name that the environment variable TEST gives, and
/// returns the exit status of the program.
inline int
run_test_of_environment(
  int                                                            argc,
  char                                                          *argv[],
  const std::map<std::string, void (*)(int argc, char *argv[])> &tests)
{
  const char *const name = std::getenv("TEST");
  const auto        test = tests.find(name == nullptr ? "" : name);
  if (test == tests.end())
    {
      std::cerr << "The environment variable TEST must be one of";
      for (const auto &[known, run] : tests)
        std::cerr << ' ' << known;
      std::cerr << '\n';
      return EXIT_FAILURE;
    }
  test->second(argc, argv);
  return EXIT_SUCCESS;
}

#endif
