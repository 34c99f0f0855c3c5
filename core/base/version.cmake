# cmake -DSOURCE=… -DVERSION=… -DOUT=… -P version.cmake: writes the version and the commit as a source, which changes only
# with them. Asks git only where the tree is a repository itself, not where it lies unpacked inside another one.
set(BUILD)
if(EXISTS ${SOURCE}/.git)
  execute_process(COMMAND git -C ${SOURCE} describe --always --exclude=* --abbrev=12 --dirty=+changes OUTPUT_VARIABLE BUILD
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT BUILD)
  set(BUILD archive)
endif()
configure_file(${SOURCE}/core/base/version.cpp.in ${OUT} @ONLY)
