"""From crunched lines to Python functions, one for each statement or for each run of them."""
