#!/bin/sh
# run.sh FOLDERS_WITH_THE_LIBRARIES: runs the Python module's tests by pytest; exits with 77 if something is missing
# here.
here=$(dirname "$0")
for python in /usr/bin/python3 python3; do
    command -v "$python" > /dev/null && "$python" -c 'import numpy, pytest' 2> /dev/null && found=$python && break
done
if [ -z "$found" ]; then
    echo "skipped: no python3 with numpy and pytest (Debian: python3-numpy python3-pytest)"
    exit 77
fi
CLAQUE_LIBRARY_DIR=$1 LIBGL_ALWAYS_SOFTWARE=1 exec "$found" -B -m pytest -q -p no:cacheprovider "$here"
