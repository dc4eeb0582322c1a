"""The work cell: sensors, and what else hangs on the auxiliary output and the free inputs."""
